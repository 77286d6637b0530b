// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PathProof.h"

#include <algorithm>
#include <utility>

namespace narrows::proof
{
namespace
{
constexpr double leastTravel = 1e-12;  // of the arm's reach: an interval that moves less is not halved
constexpr double relativeGap = 1e-4;   // of the clearance: a wider gap would cost halvings, a narrower one steps
constexpr std::size_t maxOpenPairs = 1'000'000;  // bounds time and memory on paths that can hardly be certified

template <int Dim>
Point<Dim> middleOf(const MovingSegment<Dim> &link)
{
    return 0.5 * (link.from.position + link.to.position);
}
}  // namespace

template <class Model>
PathProof<Model>::PathProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance)
  : model_(model), path_(path), tolerance_(clearanceTolerance), motion_(model.arm)
{
    double extent = motion_.extent(path);
    parts_ = partsOf(model.obstacles, extent);
    for (const Part<Dim> &part : parts_.all)
        extent = std::max(extent, part.set.center.norm() + part.set.boundingRadius + part.set.inflation);
    rounding_ = motion_.rounding(extent);
    motion_.place(path.front(), path.front(), 0.0);
    for (int link = 0; link < motion_.linkCount(); ++link)
        halfLengths_.push_back((motion_.link(link).to.position - middleOf(motion_.link(link))).norm());
    for (int second = 1; model.selfCollision && second < motion_.linkCount(); ++second)
        for (int first = 0; first < second; ++first)
            if (!motion_.areNeighbours(first, second))
                linkPairs_.emplace_back(first, second);
}

template <class Model>
Verdict PathProof<Model>::run()
{
    if (checkEnclosure() && visitWaypoints() && visitSegments())
    {
        verdict_.accepted = true;
        verdict_.clearance = settled_;
    }
    return verdict_;
}

template <class Model>
void PathProof<Model>::place(const Interval &interval)
{
    ++verdict_.placements;
    const std::size_t from = static_cast<std::size_t>(interval.segment);
    motion_.place(path_[from], path_[std::min(from + 1, path_.size() - 1)], interval.center);
}

template <class Model>
std::vector<typename PathProof<Model>::Pair> PathProof<Model>::allPairs() const
{
    std::vector<Pair> pairs;
    pairs.reserve(parts_.outermost.size() * static_cast<std::size_t>(motion_.linkCount()) + linkPairs_.size());
    for (int link = 0; link < motion_.linkCount(); ++link)
        for (const int part : parts_.outermost)
            pairs.push_back({link, part, none});
    for (const auto &[first, second] : linkPairs_)
        pairs.push_back({second, none, first});
    return pairs;
}

/// A link that meets no boundary stays inside or outside of a polygon or closed mesh, with all its points.
template <class Model>
bool PathProof<Model>::checkEnclosure()
{
    const Interval start{0, 0.0, 0.0, {}};
    place(start);
    for (int link = 0; link < motion_.linkCount(); ++link)
        for (const int part : parts_.outermost)
            if (encloses(model_.obstacles[parts_.all[part].obstacle], motion_.link(link).from.position))
                return refuse("collision", start, {link, part, none});
    return true;
}

/// Finds gross collisions and a first upper bound of the clearance, which spares most intervals their refinement.
template <class Model>
bool PathProof<Model>::visitWaypoints()
{
    std::vector<Pair> touchedNearly;  // left to the segments
    for (std::size_t i = 0; i < path_.size(); ++i)
    {
        const bool isEnd = i > 0 && i + 1 == path_.size();
        const Interval waypoint{static_cast<int>(isEnd ? i - 1 : i), isEnd ? 1.0 : 0.0, 0.0, {}};
        place(waypoint);
        for (Pair &pair : allPairs())
            if (!visit(waypoint, pair, touchedNearly))
                return false;
    }
    return true;
}

template <class Model>
bool PathProof<Model>::visitSegments()
{
    std::vector<Interval> level, halves;
    const std::size_t segments = std::max<std::size_t>(path_.size(), 2) - 1;  // a lone waypoint rests for one segment
    for (std::size_t i = 0; i < segments; ++i)
    {
        Interval segment{static_cast<int>(i), 0.5, 0.5, {}};
        place(segment);
        segment.open = allPairs();
        if (!visit(segment, halves))
            return false;
    }
    while (!halves.empty())
    {
        level.swap(halves);
        halves.clear();
        openPairs_ = 0;
        for (Interval &interval : level)
        {
            place(interval);
            if (!visit(interval, halves))
                return false;
        }
    }
    return true;
}

/// Settles what can be settled of an interval at whose center the arm is, and halves the rest.
template <class Model>
bool PathProof<Model>::visit(Interval &interval, std::vector<Interval> &halves)
{
    std::vector<Pair> open;
    for (Pair &pair : interval.open)
        if (!visit(interval, pair, open))
            return false;
    if (open.empty())
        return true;
    double furthest = 0.0;
    for (const Pair &pair : open)
        furthest = std::max(furthest, travel(pair, interval.half));
    openPairs_ += 2 * open.size();
    if (furthest <= leastTravel * model_.arm.reach() || openPairs_ > maxOpenPairs)
        return refuse("not_certified", interval, open.front());
    const double half = 0.5 * interval.half;
    halves.push_back({interval.segment, interval.center - half, half, open});
    halves.push_back({interval.segment, interval.center + half, half, std::move(open)});
    return true;
}

/// Settles a pair or adds it to `open`, in pieces if it is a box that gives way. False if something overlaps.
template <class Model>
bool PathProof<Model>::visit(const Interval &interval, Pair &pair, std::vector<Pair> &open)
{
    switch (examine(pair, interval.half))
    {
        case Finding::Settled:
            return true;
        case Finding::Open:
            open.push_back(pair);
            return true;
        case Finding::Splitting:
            return visitHalves(interval, pair, open);
        default:
            return refuse(pair.part == none ? "self_collision" : "collision", interval, pair);
    }
}

/// Visits what a box is around, beginning with what is nearer: it spares the other most of the work.
template <class Model>
bool PathProof<Model>::visitHalves(const Interval &interval, const Pair &box, std::vector<Pair> &open)
{
    const Point<Dim> middle = middleOf(motion_.link(box.link));
    int nearer = parts_.all[box.part].firstInBox, farther = parts_.all[box.part].secondInBox;
    if ((parts_.all[farther].set.center - middle).squaredNorm() <
        (parts_.all[nearer].set.center - middle).squaredNorm())
        std::swap(nearer, farther);
    Pair first{box.link, nearer, none}, second{box.link, farther, none};
    return visit(interval, first, open) && visit(interval, second, open);
}

template <class Model>
typename PathProof<Model>::Finding PathProof<Model>::examine(Pair &pair, double half)
{
    const Ball other = ballAround(pair);
    const Point<Dim> away = middleOf(motion_.link(pair.link)) - other.center;
    const double distance = away.norm();
    if (settles(distance - halfLengths_[pair.link] - other.radius - thickness(pair) - travel(pair, half) - rounding_))
        return Finding::Settled;
    if (pair.direction.isZero(0.0))
        pair.direction = distance > 0.0 ? Point<Dim>(away / distance) : Point<Dim>(Point<Dim>::UnitX());
    if (settlesAlong(pair, half))
        return Finding::Settled;
    const Separation<Dim> found = separation(pair, half);
    pair.direction = found.direction;
    const bool isBox = pair.part != none && parts_.all[pair.part].isBox();
    if (!isBox)  // a box may be met without harm
    {
        const double clearance = found.upper - thickness(pair);
        least_ = std::min(least_, clearance);
        if (clearance <= 0.0)
            return Finding::Overlapping;
    }
    if (settlesAlong(pair, half))
        return Finding::Settled;
    const double now = found.lower - thickness(pair) - rounding_;
    if (isEnough(now - bendingWay(pair, half)) && settlesTurning(pair, half))
        return Finding::Settled;
    return isBox && parts_.all[pair.part].set.boundingRadius >= travel(pair, half) ? Finding::Splitting : Finding::Open;
}

template <class Model>
Separation<PathProof<Model>::Dim> PathProof<Model>::separation(const Pair &pair, double half) const
{
    SeparationGoal goal;
    goal.thickness = thickness(pair);
    goal.enough = least_ + goal.thickness + rounding_ + travel(pair, half);
    goal.relativeGap = relativeGap;
    goal.absoluteGap = 0.25 * tolerance_;
    goal.rounding = 0.25 * rounding_;
    const Segment<Dim> link = motion_.link(pair.link).now();
    return pair.part == none ? separate<Dim>(motion_.link(pair.secondLink).now(), link, pair.direction, goal)
                             : separate<Dim>(parts_.all[pair.part].set, link, pair.direction, goal);
}

/// Whether a lower bound of a pair's clearance makes further work on it idle: it is free, and cannot lower the path's
/// clearance by more than the tolerance.
template <class Model>
bool PathProof<Model>::isEnough(double clearance) const
{
    return clearance > 0.0 && clearance >= least_ - tolerance_;
}

template <class Model>
bool PathProof<Model>::settles(double clearance)
{
    if (!isEnough(clearance))
        return false;
    settled_ = std::min(settled_, clearance);
    return true;
}

/// Of both sides together, around the segments and cores.
template <class Model>
double PathProof<Model>::thickness(const Pair &pair) const
{
    return motion_.radius(pair.link) +
           (pair.part == none ? motion_.radius(pair.secondLink) : parts_.all[pair.part].set.inflation);
}

/// How far the two sides can move against each other at most.
template <class Model>
double PathProof<Model>::travel(const Pair &pair, double half) const
{
    const double second = pair.part == none ? motion_.link(pair.secondLink).to.travel : 0.0;
    return (motion_.link(pair.link).to.travel + second) * half;
}

/// What no turning line or plane can make up for: the way by acceleration.
template <class Model>
double PathProof<Model>::bendingWay(const Pair &pair, double half) const
{
    const double second = pair.part == none ? motion_.link(pair.secondLink).to.bend : 0.0;
    return 0.5 * (motion_.link(pair.link).to.bend + second) * half * half;
}

/// What the link shall keep away from is in this ball, its inflation left out.
template <class Model>
typename PathProof<Model>::Ball PathProof<Model>::ballAround(const Pair &pair) const
{
    if (pair.part == none)
        return {middleOf(motion_.link(pair.secondLink)), halfLengths_[pair.secondLink]};
    const ConvexSet<Dim> &set = parts_.all[pair.part].set;
    return {set.center, set.boundingRadius};
}

/// By the line or plane that the pair was last separated by, at rest.
template <class Model>
bool PathProof<Model>::settlesAlong(const Pair &pair, double half)
{
    double apart = 0.0;
    if (pair.part == none)
    {
        const MovingPair<Dim> links = motion_.between(pair.secondLink, pair.link);
        apart = keptApart<Dim>({pair.direction}, links.second, links.first, half);
    }
    else
        apart = keptApart<Dim>({pair.direction}, motion_.link(pair.link), parts_.all[pair.part].set, half);
    return settles(apart - thickness(pair) - rounding_);
}

/// By the same, turning with what it separates: far better where something glides along a link.
template <class Model>
bool PathProof<Model>::settlesTurning(const Pair &pair, double half)
{
    return pair.part == none ? settlesBetweenLinks(pair, half) : settlesBesidePart(pair, half);
}

template <class Model>
bool PathProof<Model>::settlesBetweenLinks(const Pair &pair, double half)
{
    const MovingPair<Dim> links = motion_.between(pair.secondLink, pair.link);
    const auto settlesBy = [&](const std::optional<TurningPlane<Dim>> &plane)
    {
        return plane && settles(keptApart<Dim>(*plane, links.second, links.first, half) - thickness(pair) - rounding_);
    };
    const TurningPlane<Dim> atRest{pair.direction};
    const std::optional<TurningPlane<Dim>> withFirst = atRest.following(links.first);
    if (settlesBy(withFirst) || settlesBy(atRest.following(links.second)))
        return true;
    if constexpr (Dim == 3)
        return withFirst && settlesBy(followingBoth(*withFirst, links.first, links.second));
    return false;
}

template <class Model>
bool PathProof<Model>::settlesBesidePart(const Pair &pair, double half)
{
    const MovingSegment<Dim> &link = motion_.link(pair.link);
    const ConvexSet<Dim> &set = parts_.all[pair.part].set;
    const auto settlesBy = [&](const std::optional<TurningPlane<Dim>> &plane)
    {
        return plane && settles(keptApart<Dim>(*plane, link, set, half) - thickness(pair) - rounding_);
    };
    const std::optional<TurningPlane<Dim>> withLink = TurningPlane<Dim>{pair.direction}.following(link);
    if (settlesBy(withLink))
        return true;
    if constexpr (Dim == 3)
        return withLink && settlesBy(followingBoth(*withLink, link, edgeAt(*withLink, set, half)));
    return false;
}

template <class Model>
bool PathProof<Model>::refuse(const char *reason, const Interval &interval, const Pair &pair)
{
    verdict_.reason = reason;
    verdict_.segment = interval.segment;
    verdict_.fraction = interval.center;
    verdict_.link = pair.link;
    verdict_.otherLink = pair.secondLink;
    if (pair.part != none)
        verdict_.obstacle = model_.obstacles[parts_.all[pair.part].obstacle].name;
    return false;
}

template class PathProof<PlanarModel>;
template class PathProof<SpatialModel>;
}  // namespace narrows::proof
