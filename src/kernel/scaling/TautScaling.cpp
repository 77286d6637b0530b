// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TautScaling.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// How much farther than the margin from an obstacle behind the tip its string is held: the hold's way along the
/// boundary is a polygon, which must not touch the region.
constexpr double holdMargin = 1.02;

std::vector<std::vector<Vector2d>> dangerPolygons(const ScalingProblem &problem, const ScalingOptions &options)
{
    std::vector<std::vector<Vector2d>> polygons;
    for (std::size_t s = 0; s < problem.sections.size(); ++s)
        polygons.push_back(problem.sections[s].dangerPolygon(options.marginOf(s)));
    return polygons;
}
}  // namespace

TautScaling::TautScaling(const ScalingProblem &problem, const ScalingOptions &options)
  : problem_(problem),
    options_(options),
    fractions_(problem.fractions()),
    easing_(problem, options),
    string_(dangerPolygons(problem, options), Vector2d::Zero())
{
    for (std::size_t s = 0; s < problem.sections.size(); ++s)
        holds_.push_back(options.isBehind(s) ? problem.sections[s].dangerPolygon(holdMargin * options.marginOf(s))
                                             : Outline());
    for (const Vector2d &point : options.wrapping)
        string_.moveTip(point);
}

std::optional<std::size_t> TautScaling::blockedBy(const Vector2d &tip) const
{
    for (std::size_t s = 0; s < problem_.sections.size(); ++s)
        if (problem_.sections[s].isCloser(tip, tip, (holds_[s].empty() ? 1.0 : holdMargin) * options_.marginOf(s)))
            return s;
    return std::nullopt;
}

ScalingFault TautScaling::place(const Vector2d &tip, SectionChain &chain)
{
    const std::optional<std::size_t> blocker = blockedBy(tip);
    if (blocker && holds_[*blocker].empty())
        return {ScalingFailure::TipBlocked, static_cast<int>(problem_.links()) - 1, static_cast<int>(*blocker)};
    Vector2d held = tip;
    if (blocker)
    {
        const Vector2d &center = problem_.sections[*blocker].center();
        const std::optional<Stretch> inside = clip(center, tip, holds_[*blocker]);
        if (inside && inside->leaves > 1.0)
            held = center + inside->leaves * (tip - center);
    }
    string_.moveTip(held);
    string_.pointsAt(fractions_, tip, chain);
    chain.back() = tip;                     // exactly
    std::size_t before = problem_.links();  // links that are not before the obstacle, whose tip is in its region
    const double share = string_.length() / (string_.length() + (tip - held).norm());
    while (blocker && before > 0 && fractions_[before] > share)
        --before;
    // A straight string keeps the margin.
    if (!string_.contacts().empty())
        easing_.ease(chain, blocker, before);
    return {};
}
}  // namespace narrows
