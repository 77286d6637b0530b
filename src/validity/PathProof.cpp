// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PathProof.h"

#include <algorithm>
#include <utility>

namespace narrows::proof
{
namespace
{
constexpr double leastTravel = 1e-12;            // of the arm's reach: an interval that moves less is not halved
constexpr std::size_t maxOpenPairs = 1'000'000;  // bounds time and memory on paths that can hardly be certified
}  // namespace

template <class Model>
PathProof<Model>::PathProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance)
  : model_(model), path_(path), pairs_(model, path, clearanceTolerance)
{
}

template <class Model>
Verdict PathProof<Model>::run()
{
    if (checkEnclosure() && visitWaypoints() && visitSegments())
    {
        verdict_.accepted = true;
        verdict_.clearance = pairs_.settled();
    }
    return verdict_;
}

template <class Model>
void PathProof<Model>::place(const Interval &interval)
{
    ++verdict_.placements;
    const std::size_t from = static_cast<std::size_t>(interval.segment);
    pairs_.place(path_[from], path_[std::min(from + 1, path_.size() - 1)], interval.center);
}

/// A link that meets no boundary stays inside or outside of a polygon or closed mesh, with all its points.
template <class Model>
bool PathProof<Model>::checkEnclosure()
{
    const Interval start{0, 0.0, 0.0, {}};
    place(start);
    const auto &parts = pairs_.parts().all;
    for (std::size_t i = 0; i < model_.obstacles.size(); ++i)
        for (int link = 0; link < pairs_.motion().linkCount(); ++link)
            if (encloses(model_.obstacles[i], pairs_.motion().link(link).from.position))
            {
                const auto itsPart = std::find_if(
                    parts.begin(), parts.end(), [i](const auto &part) { return part.obstacle == static_cast<int>(i); });
                return refuse("collision", start,
                              {link, static_cast<int>(itsPart - parts.begin()), PairProof<Model>::none});
            }
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
        for (Pair &pair : pairs_.allPairs())
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
        segment.open = pairs_.allPairs();
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
        furthest = std::max(furthest, pairs_.travel(pair, interval.half));
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
    switch (pairs_.examine(pair, interval.half))
    {
        case Finding::Settled:
            return true;
        case Finding::Open:
            open.push_back(pair);
            return true;
        case Finding::Splitting:
            for (Pair &inside : pairs_.split(pair))
                if (!visit(interval, inside, open))
                    return false;
            return true;
        default:
            return refuse(pair.part == PairProof<Model>::none ? "self_collision" : "collision", interval, pair);
    }
}

template <class Model>
bool PathProof<Model>::refuse(const char *reason, const Interval &interval, const Pair &pair)
{
    verdict_.reason = reason;
    verdict_.segment = interval.segment;
    verdict_.fraction = interval.center;
    verdict_.link = pair.link;
    verdict_.otherLink = pair.secondLink;
    if (pair.part != PairProof<Model>::none)
        verdict_.obstacle = model_.obstacles[pairs_.parts().all[pair.part].obstacle].name;
    return false;
}

template class PathProof<PlanarModel>;
template class PathProof<SpatialModel>;
}  // namespace narrows::proof
