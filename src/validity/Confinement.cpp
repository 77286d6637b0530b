// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Confinement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "validity/DiscCover.h"

namespace narrows
{
namespace
{
constexpr double depth = 1e-9;  ///< a length; more than rounding moves a point of scenes of usual size

/// Limits of the first joint. An angle of the first link against its parent, the base, is an absolute one.
std::optional<Interval> limitsOfFirst(const PlanarModel &model, const PlanarTask &task)
{
    if (const auto &slide = model.arm.slide())
        return Interval{slide->lower, slide->upper};
    return task.limits.angles.front();
}

bool staysBetween(const Interval &interval, double value, bool turns)
{
    if (turns)
        value -= 2.0 * M_PI * std::floor((value - interval.lower) / (2.0 * M_PI));
    return value >= interval.lower && value <= interval.upper;
}

/// Where the point is when the first joint has this value.
Eigen::Vector2d pointAt(const PlanarArm &arm, double value, double along)
{
    if (arm.slide())
        return arm.base() + value * arm.slide()->axis;
    return arm.base() + along * Eigen::Vector2d(std::cos(value), std::sin(value));
}

std::string whyNotStopped(const PlanarModel &model, double value, double along)
{
    const double longest = model.arm.slide() ? 0.0 : model.arm.links().front().length;
    if (!(along >= 0.0 && along <= longest))
        return fmt::format("there is no point {} from the base on what the first joint alone moves", along);
    const Eigen::Vector2d point = pointAt(model.arm, value, along);
    const auto covers = [&](const PlanarObstacle &obstacle)
    {
        return coversDisc(obstacle, point, depth);
    };
    if (std::none_of(model.obstacles.begin(), model.obstacles.end(), covers))
        return fmt::format("nothing stops the first joint at {}: ({:.6g}, {:.6g}) is in no obstacle", value, point.x(),
                           point.y());
    return "";
}
}  // namespace

std::string whyNoProof(const Confinement &confinement, const PlanarModel &model, const PlanarTask &task)
{
    const Interval &first = confinement.first;
    const auto *goal = std::get_if<Eigen::VectorXd>(&task.goal);
    if (goal == nullptr)
        return "the goal does not say where the first joint shall be";
    if (!(task.start[0] > first.lower && task.start[0] < first.upper))
        return fmt::format("the start's first joint, {}, is not between {} and {}", task.start[0], first.lower,
                           first.upper);
    const std::optional<Interval> limits = limitsOfFirst(model, task);
    if (staysBetween(first, (*goal)[0], !limits))
        return fmt::format("the goal's first joint, {}, is not outside of {} to {}", (*goal)[0], first.lower,
                           first.upper);
    std::string reason;
    if (!limits || limits->lower < first.lower)
        reason = whyNotStopped(model, first.lower, confinement.along[0]);
    if (reason.empty() && (!limits || limits->upper > first.upper))
        reason = whyNotStopped(model, first.upper, confinement.along[1]);
    return reason;
}
}  // namespace narrows
