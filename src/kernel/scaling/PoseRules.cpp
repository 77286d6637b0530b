// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/PoseRules.h"

#include <algorithm>
#include <cmath>

#include "kernel/SegmentDistance.h"

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
/// Rules are kept with this much to spare, relatively, so that checkers do not see them broken by rounding.
constexpr double spare = 1e-7;
}  // namespace

PoseRules::PoseRules(const ScalingProblem &problem)
  : problem_(problem),
    cosine_(problem.maxAngle < std::acos(-1.0) ? std::cos(problem.maxAngle) + spare : -2.0),
    needed_(problem.radius + spare * problem.reach())
{
}

ScalingFault PoseRules::lift(const SectionChain &chain, double tipX, Vector3d *centres) const
{
    double x = tipX;
    for (std::size_t i = problem_.links(); i > 0; --i)
    {
        centres[i] = Vector3d(x, chain[i].x(), chain[i].y());
        const double length = problem_.lengths[i - 1];
        const double rest = length * length - (chain[i] - chain[i - 1]).squaredNorm();
        if (!(rest > 0.0))
            return {ScalingFailure::Span, static_cast<int>(i) - 1};
        x -= std::sqrt(rest);
    }
    centres[0] = Vector3d(x, chain[0].x(), chain[0].y());
    return {};
}

ScalingFault PoseRules::check(const Vector3d *centres) const
{
    if (centres[0].x() < problem_.slide.lower || centres[0].x() > problem_.slide.upper)
        return {ScalingFailure::Slide};
    Vector3d before = problem_.forward;
    double beforeLength = 1.0;
    for (std::size_t i = 0; i < problem_.links(); ++i)
    {
        const Vector3d link = centres[i + 1] - centres[i];
        if (isBent(before, link, beforeLength * problem_.lengths[i]))
            return {ScalingFailure::LinkAngle, static_cast<int>(i)};
        before = link;
        beforeLength = problem_.lengths[i];
    }
    for (std::size_t i = 0; i < problem_.links(); ++i)
    {
        const int section = blockingSection(centres[i], centres[i + 1]);
        if (section >= 0 || blockingCrossbar(centres[i], centres[i + 1]) >= 0)
            return {ScalingFailure::LinkClearance, static_cast<int>(i), section};
    }
    return {};
}

int PoseRules::blockingSection(const Vector3d &from, const Vector3d &to) const
{
    const Vector2d a = from.tail<2>();
    const Vector2d b = to.tail<2>();
    for (std::size_t s = 0; s < problem_.sections.size(); ++s)
    {
        const ConvexSection &section = problem_.sections[s];
        if (section.isCloser(a, b, needed_) && std::max(from.x(), to.x()) + needed_ > section.span().lower &&
            std::min(from.x(), to.x()) - needed_ < section.span().upper)
            return static_cast<int>(s);
    }
    return -1;
}

int PoseRules::blockingCrossbar(const Vector3d &from, const Vector3d &to) const
{
    for (std::size_t s = 0; s < problem_.crossbars.size(); ++s)
    {
        const Crossbar &bar = problem_.crossbars[s];
        const Vector2d a(from.x(), bar.across.dot(from.tail<2>()));
        const Vector2d b(to.x(), bar.across.dot(to.tail<2>()));
        const double far = bar.radius + needed_;
        if (squaredDistance(a, b, {bar.x, bar.offset}) < far * far)
            return static_cast<int>(s);
    }
    return -1;
}

std::vector<double> linkAngles(const ScalingProblem &problem, const Vector3d *centres)
{
    std::vector<double> angles;
    Vector3d before = problem.forward;
    for (std::size_t i = 0; i < problem.links(); ++i)
    {
        const Vector3d link = centres[i + 1] - centres[i];
        angles.push_back(std::atan2(before.cross(link).norm(), before.dot(link)));
        before = link;
    }
    return angles;
}
}  // namespace narrows
