// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SupportDistance.h"

#include <algorithm>
#include <optional>

#include "validity/Simplex.h"
#include "validity/SupportPoints.h"

namespace narrows::proof
{
namespace
{
constexpr int maxSteps = 100;    // a gap that shrinks fourfold is below rounding after about 25
constexpr int maxIdleSteps = 4;  // in a row, without gain

template <int Dim>
bool reached(const SeparationGoal &goal, const Separation<Dim> &found)
{
    const double gap = found.upper - found.lower;
    const double usefulGap = std::min(goal.absoluteGap, goal.relativeGap * (found.upper - goal.thickness));
    return found.upper <= goal.thickness || found.lower >= goal.enough || gap <= std::max(goal.rounding, usefulGap);
}

/// \tparam Core any shape that furthestOf() knows
template <int Dim, class Core>
Separation<Dim> raise(const Core &core, const Segment<Dim> &segment, const Point<Dim> &guess,
                      const SeparationGoal &goal)
{
    Separation<Dim> best{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), guess};
    std::optional<Simplex<Dim>> simplex;
    Point<Dim> u = guess;
    int idle = 0;
    for (int step = 0; step < maxSteps && idle < maxIdleSteps; ++step)
    {
        const Separation<Dim> before = best;
        const Point<Dim> point = furthestOf(core, u);
        const Point<Dim> fromA = segment.from - point, fromB = segment.to - point;
        const Point<Dim> &extreme = fromA.dot(u) <= fromB.dot(u) ? fromA : fromB;
        if (extreme.dot(u) > best.lower)
        {
            best.lower = extreme.dot(u);
            best.direction = u;
        }
        const bool apart = !simplex || simplex->extend(extreme);
        if (!simplex)
            simplex.emplace(extreme);
        best.upper = apart ? std::min(best.upper, simplex->nearest().norm()) : 0.0;
        if (reached(goal, best))
            break;
        idle = best.lower == before.lower && best.upper == before.upper ? idle + 1 : 0;
        u = simplex->direction();
    }
    return best;
}
}  // namespace

template <int Dim>
Point<Dim> supportPoint(const ConvexSet<Dim> &set, const Point<Dim> &u)
{
    return std::visit([&u](const auto &core) -> Point<Dim> { return furthestOf(core, u); }, set.core);
}

template <int Dim>
Separation<Dim> separate(const ConvexSet<Dim> &set, const Segment<Dim> &segment, const Point<Dim> &guess,
                         const SeparationGoal &goal)
{
    return std::visit([&](const auto &core) { return raise<Dim>(core, segment, guess, goal); }, set.core);
}

template <int Dim>
Separation<Dim> separate(const Segment<Dim> &core, const Segment<Dim> &segment, const Point<Dim> &guess,
                         const SeparationGoal &goal)
{
    return raise<Dim>(core, segment, guess, goal);
}

template Point<2> supportPoint(const ConvexSet<2> &, const Point<2> &);
template Point<3> supportPoint(const ConvexSet<3> &, const Point<3> &);
template Separation<2> separate(const ConvexSet<2> &, const Segment<2> &, const Point<2> &, const SeparationGoal &);
template Separation<3> separate(const ConvexSet<3> &, const Segment<3> &, const Point<3> &, const SeparationGoal &);
template Separation<2> separate(const Segment<2> &, const Segment<2> &, const Point<2> &, const SeparationGoal &);
template Separation<3> separate(const Segment<3> &, const Segment<3> &, const Point<3> &, const SeparationGoal &);
}  // namespace narrows::proof
