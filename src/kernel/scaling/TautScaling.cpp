// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TautScaling.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
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
    for (const Vector2d &point : options.wrapping)
        string_.moveTip(point);
}

ScalingFault TautScaling::place(const Vector2d &tip, SectionChain &chain)
{
    for (std::size_t s = 0; s < problem_.sections.size(); ++s)
        if (problem_.sections[s].isCloser(tip, tip, options_.marginOf(s)))
            return {ScalingFailure::TipBlocked, static_cast<int>(problem_.links()) - 1, static_cast<int>(s)};
    string_.moveTip(tip);
    string_.pointsAt(fractions_, chain);
    chain.back() = tip;  // exactly
    // A straight string keeps the margin.
    if (!string_.contacts().empty())
        easing_.ease(chain);
    return {};
}
}  // namespace narrows
