// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PathProof.h"

#include <algorithm>
#include <utility>

#include "validity/ConvexSets.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr double leastTravel = 1e-12;  // of the arm's reach: an interval that moves less is not halved
constexpr double relativeGap = 1e-4;   // of the clearance: a wider gap would cost halvings, a narrower one steps
constexpr std::size_t maxOpenPairs = 1'000'000;  // bounds time and memory on paths that can hardly be certified
}  // namespace

PathProof::PathProof(const PlanarModel &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance)
  : model_(model), path_(path), tolerance_(clearanceTolerance), motion_(model.arm)
{
    for (std::size_t i = 0; i < model_.obstacles.size(); ++i)
        for (ConvexSet &set : convexSets(model_.obstacles[i]))
        {
            const double thickness = model_.arm.radius() + set.inflation;
            pieces_.push_back({std::move(set), static_cast<int>(i), thickness});
        }
    estimateRounding();
}

Verdict PathProof::run()
{
    if (checkBase() && visitWaypoints() && visitSegments())
    {
        verdict_.accepted = true;
        verdict_.clearance = settled_;
    }
    return verdict_;
}

/// Angles enter with their own rounding, which grows with the number of turns.
void PathProof::estimateRounding()
{
    double largestValue = 1.0;
    for (const Eigen::VectorXd &row : path_)
        largestValue = std::max(largestValue, row.cwiseAbs().maxCoeff());
    double extent = model_.arm.base().norm() + model_.arm.reach() * largestValue;
    if (model_.arm.slide())
        extent += largestValue;
    for (const Piece &piece : pieces_)
        extent = std::max(extent, piece.set.center.norm() + piece.set.boundingRadius + piece.set.inflation);
    rounding_ = (32 + 4 * model_.arm.linkCount()) * std::numeric_limits<double>::epsilon() * extent;
}

void PathProof::place(const Interval &interval)
{
    const std::size_t from = static_cast<std::size_t>(interval.segment);
    motion_.place(path_[from], path_[std::min(from + 1, path_.size() - 1)], interval.center);
}

std::vector<PathProof::Pair> PathProof::allPairs() const
{
    std::vector<Pair> pairs;
    pairs.reserve(pieces_.size() * static_cast<std::size_t>(model_.arm.linkCount()));
    for (int link = 0; link < model_.arm.linkCount(); ++link)
        for (std::size_t i = 0; i < pieces_.size(); ++i)
        {
            const Vector2d middle = 0.5 * (motion_.point(motion_.baseOf(link)) + motion_.point(motion_.tipOf(link)));
            const Vector2d away = middle - pieces_[i].set.center;
            pairs.push_back({link, static_cast<int>(i), away.norm() > 0.0 ? away.normalized() : Vector2d(1.0, 0.0)});
        }
    return pairs;
}

/// The links hang together, so that an arm that meets no boundary is inside a polygon iff its base is.
bool PathProof::checkBase()
{
    const Interval start{0, 0.0, 0.0, {}};
    place(start);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (polygonEncloses(model_.obstacles[pieces_[i].obstacle], motion_.point(0)))
            return refuse("collision", start, {0, static_cast<int>(i), {}});
    return true;
}

/// Finds gross collisions and a first upper bound of the clearance, which spares most intervals their refinement.
bool PathProof::visitWaypoints()
{
    for (std::size_t i = 0; i < path_.size(); ++i)
    {
        const bool isEnd = i > 0 && i + 1 == path_.size();
        const Interval waypoint{static_cast<int>(isEnd ? i - 1 : i), isEnd ? 1.0 : 0.0, 0.0, {}};
        place(waypoint);
        for (Pair &pair : allPairs())
            if (examine(pair, 0.0) == Finding::Overlapping)
                return refuse("collision", waypoint, pair);
    }
    return true;
}

bool PathProof::visitSegments()
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
bool PathProof::visit(Interval &interval, std::vector<Interval> &halves)
{
    std::vector<Pair> open;
    double travel = 0.0;
    for (Pair &pair : interval.open)
    {
        const Finding finding = examine(pair, interval.half);
        if (finding == Finding::Overlapping)
            return refuse("collision", interval, pair);
        if (finding == Finding::Settled)
            continue;
        travel = std::max(travel, motion_.travel(motion_.tipOf(pair.link), interval.half));
        open.push_back(pair);
    }
    if (open.empty())
        return true;
    openPairs_ += 2 * open.size();
    if (travel <= leastTravel * model_.arm.reach() || openPairs_ > maxOpenPairs)
        return refuse("not_certified", interval, open.front());
    const double half = 0.5 * interval.half;
    halves.push_back({interval.segment, interval.center - half, half, open});
    halves.push_back({interval.segment, interval.center + half, half, std::move(open)});
    return true;
}

PathProof::Finding PathProof::examine(Pair &pair, double half)
{
    if (settles(roughClearance(pair, half)) || settles(clearanceAlong(pair, half)))
        return Finding::Settled;
    const Piece &piece = pieces_[pair.piece];
    SeparationGoal goal;
    goal.thickness = piece.thickness;
    goal.enough = least_ + piece.thickness + rounding_ + motion_.travel(motion_.tipOf(pair.link), half);
    goal.relativeGap = relativeGap;
    goal.absoluteGap = 0.25 * tolerance_;
    goal.rounding = 0.25 * rounding_;
    const Separation found = separate(piece.set, motion_.point(motion_.baseOf(pair.link)),
                                      motion_.point(motion_.tipOf(pair.link)), pair.direction, goal);
    const double clearance = found.upper - piece.thickness;
    pair.direction = found.direction;
    least_ = std::min(least_, clearance);
    if (clearance <= 0.0)
        return Finding::Overlapping;
    return settles(clearanceAlong(pair, half)) ? Finding::Settled : Finding::Open;
}

/// Whether a lower bound of a pair's clearance makes further work on it idle: it is free, and cannot lower the path's
/// clearance by more than the tolerance.
bool PathProof::settles(double clearance)
{
    if (!(clearance > 0.0) || clearance < least_ - tolerance_)
        return false;
    settled_ = std::min(settled_, clearance);
    return true;
}

/// Lower bound of the clearance during an interval, from bounding circles.
double PathProof::roughClearance(const Pair &pair, double half) const
{
    const Piece &piece = pieces_[pair.piece];
    const Vector2d &base = motion_.point(motion_.baseOf(pair.link));
    const Vector2d &tip = motion_.point(motion_.tipOf(pair.link));
    const double distance = (0.5 * (base + tip) - piece.set.center).norm() - 0.5 * (tip - base).norm();
    return distance - piece.set.boundingRadius - piece.thickness - motion_.travel(motion_.tipOf(pair.link), half) -
           rounding_;
}

/// Lower bound of the clearance during an interval, from the line that the pair was last separated by.
double PathProof::clearanceAlong(const Pair &pair, double half) const
{
    const Piece &piece = pieces_[pair.piece];
    const Vector2d support = supportPoint(piece.set, pair.direction);
    double separation = std::numeric_limits<double>::infinity();
    for (const int end : {motion_.baseOf(pair.link), motion_.tipOf(pair.link)})
        separation = std::min(separation, (motion_.point(end) - support).dot(pair.direction) -
                                              motion_.travelAlong(end, pair.direction, half));
    return separation - piece.thickness - rounding_;
}

bool PathProof::refuse(const char *reason, const Interval &interval, const Pair &pair)
{
    verdict_.reason = reason;
    verdict_.segment = interval.segment;
    verdict_.fraction = interval.center;
    verdict_.link = pair.link;
    verdict_.obstacle = model_.obstacles[pieces_[pair.piece].obstacle].name;
    return false;
}
}  // namespace narrows
