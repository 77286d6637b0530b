// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/TaskReader.h"

#include <algorithm>

#include <fmt/format.h>

#include "scenario/StateReader.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
std::optional<Eigen::VectorXd> readStart(const Field &field, const RobotDraft &robot)
{
    const Mapping start(field);
    start.allowOnly({"angles", "points", "slide"});
    if (start.valid() && !start.has("angles") && !start.has("points"))
        field.fault("must have angles or points");
    return readState(start, robot);
}

/// Distances from the base at which the tip of a chain can be.
struct Reach
{
    double nearest;
    double farthest;
};

Reach reachOf(const PlanarArm &arm, int link)
{
    double total = 0.0;
    double longest = 0.0;
    for (int i = link; i >= 0; i = arm.links()[static_cast<std::size_t>(i)].parent)
    {
        const double length = arm.links()[static_cast<std::size_t>(i)].length;
        total += length;
        longest = std::max(longest, length);
    }
    return {std::max(0.0, 2.0 * longest - total), total};
}

/// Ignores obstacles and limits of the joints.
void checkReach(const Field &field, const PlanarArm &arm, const TipGoal &goal)
{
    const Slide slide = arm.slide().value_or(Slide{Eigen::Vector2d::UnitX(), 0.0, 0.0});
    const Eigen::Vector2d offset = goal.point - arm.base();
    const double foot = std::clamp(offset.dot(slide.axis), slide.lower, slide.upper);
    const double least = (offset - foot * slide.axis).norm();
    const double most =
        std::max((offset - slide.lower * slide.axis).norm(), (offset - slide.upper * slide.axis).norm());
    const Reach reach = reachOf(arm, goal.link);
    if (least - goal.tolerance > reach.farthest)
        field.fault(fmt::format("out of reach: {:.6g} away from the base, but the chain to link {} is {:.6g} long",
                                least, goal.link + 1, reach.farthest));
    else if (most + goal.tolerance < reach.nearest)
        field.fault(
            fmt::format("out of reach: {:.6g} away from the base, but the tip of link {} cannot come nearer "
                        "than {:.6g}",
                        most, goal.link + 1, reach.nearest));
}

std::optional<TipGoal> readTipGoal(const Mapping &goal, const RobotDraft &robot)
{
    goal.allowOnly({"tip", "tolerance", "link"});
    const std::optional<Eigen::Vector2d> point = goal.required("tip").point();
    const std::optional<double> tolerance = goal.required("tolerance").positive();
    const int links = robot.linkCount;
    const Field linkField = goal.optional("link");
    const std::optional<int> link =
        linkField.given() && links > 0 ? linkField.integer(1, links) : std::optional<int>(links);
    if (!point || !tolerance || !link || !robot.arm)
        return std::nullopt;
    const TipGoal tip{*link - 1, *point, *tolerance};
    checkReach(goal.optional("tip"), *robot.arm, tip);
    return tip;
}

std::optional<std::variant<Eigen::VectorXd, TipGoal>> readGoal(const Field &field, const RobotDraft &robot)
{
    const Mapping goal(field);
    if (goal.has("tip"))
        return readTipGoal(goal, robot);
    goal.allowOnly({"angles", "points", "slide", "tip"});
    if (goal.valid() && !goal.has("angles") && !goal.has("points"))
        field.fault("must have angles, points or tip");
    return readState(goal, robot);
}

}  // namespace

std::optional<PlanarTask> readTask(const Field &start, const Field &goal, const RobotDraft &robot)
{
    const std::optional<Eigen::VectorXd> from = readStart(start, robot);
    const auto to = readGoal(goal, robot);
    if (!from || !to)
        return std::nullopt;
    return PlanarTask{*from, *to, robot.limits};
}
}  // namespace narrows
