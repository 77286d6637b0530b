// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PairProof.h"

#include <algorithm>
#include <optional>

namespace narrows::proof
{
namespace
{
constexpr double relativeGap = 1e-4;  // of the clearance: a wider gap would cost halvings, a narrower one steps

template <int Dim>
Point<Dim> middleOf(const MovingSegment<Dim> &link)
{
    return 0.5 * (link.from.position + link.to.position);
}
}  // namespace

template <class Model>
PairProof<Model>::PairProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance)
  : tolerance_(clearanceTolerance), motion_(model.arm)
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
std::vector<typename PairProof<Model>::Pair> PairProof<Model>::allPairs() const
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

template <class Model>
std::array<typename PairProof<Model>::Pair, 2> PairProof<Model>::split(const Pair &box) const
{
    const Point<Dim> middle = middleOf(motion_.link(box.link));
    int nearer = parts_.all[box.part].firstInBox, farther = parts_.all[box.part].secondInBox;
    if ((parts_.all[farther].set.center - middle).squaredNorm() <
        (parts_.all[nearer].set.center - middle).squaredNorm())
        std::swap(nearer, farther);
    return {Pair{box.link, nearer, none}, Pair{box.link, farther, none}};
}

template <class Model>
typename PairProof<Model>::Finding PairProof<Model>::examine(Pair &pair, double half)
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
Separation<PairProof<Model>::Dim> PairProof<Model>::separation(const Pair &pair, double half) const
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
bool PairProof<Model>::isEnough(double clearance) const
{
    return clearance > 0.0 && clearance >= least_ - tolerance_;
}

template <class Model>
bool PairProof<Model>::settles(double clearance)
{
    if (!isEnough(clearance))
        return false;
    settled_ = std::min(settled_, clearance);
    return true;
}

/// Of both sides together, around the segments and cores.
template <class Model>
double PairProof<Model>::thickness(const Pair &pair) const
{
    return motion_.radius(pair.link) +
           (pair.part == none ? motion_.radius(pair.secondLink) : parts_.all[pair.part].set.inflation);
}

/// How far the two sides can move against each other at most.
template <class Model>
double PairProof<Model>::travel(const Pair &pair, double half) const
{
    const double second = pair.part == none ? motion_.link(pair.secondLink).to.travel : 0.0;
    return (motion_.link(pair.link).to.travel + second) * half;
}

/// What no turning line or plane can make up for: the way by acceleration.
template <class Model>
double PairProof<Model>::bendingWay(const Pair &pair, double half) const
{
    const double second = pair.part == none ? motion_.link(pair.secondLink).to.bend : 0.0;
    return 0.5 * (motion_.link(pair.link).to.bend + second) * half * half;
}

/// What the link shall keep away from is in this ball, its inflation left out.
template <class Model>
typename PairProof<Model>::Ball PairProof<Model>::ballAround(const Pair &pair) const
{
    if (pair.part == none)
        return {middleOf(motion_.link(pair.secondLink)), halfLengths_[pair.secondLink]};
    const ConvexSet<Dim> &set = parts_.all[pair.part].set;
    return {set.center, set.boundingRadius};
}

/// By the line or plane that the pair was last separated by, at rest.
template <class Model>
bool PairProof<Model>::settlesAlong(const Pair &pair, double half)
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
bool PairProof<Model>::settlesTurning(const Pair &pair, double half)
{
    return pair.part == none ? settlesBetweenLinks(pair, half) : settlesBesidePart(pair, half);
}

template <class Model>
bool PairProof<Model>::settlesBetweenLinks(const Pair &pair, double half)
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
bool PairProof<Model>::settlesBesidePart(const Pair &pair, double half)
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

template class PairProof<PlanarModel>;
template class PairProof<SpatialModel>;
}  // namespace narrows::proof
