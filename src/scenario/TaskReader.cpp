// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/TaskReader.h"

#include "scenario/StateReader.h"
#include "scenario/TipReach.h"
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

Eigen::Vector3d inSpace(const Eigen::Vector2d &point)
{
    return {point.x(), point.y(), 0.0};
}

TipReach reachOf(const PlanarArm &arm, const TipGoal &goal)
{
    std::vector<double> lengths;
    for (int i = goal.link; i >= 0; i = arm.links()[static_cast<std::size_t>(i)].parent)
        lengths.push_back(arm.links()[static_cast<std::size_t>(i)].length);
    const Slide slide = arm.slide().value_or(Slide{Eigen::Vector2d::UnitX(), 0.0, 0.0});
    return {lengths,
            inSpace(arm.base() + slide.lower * slide.axis),
            inSpace(arm.base() + slide.upper * slide.axis),
            inSpace(goal.point),
            goal.tolerance,
            goal.link + 1};
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
    checkReach(goal.optional("tip"), reachOf(*robot.arm, tip));
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
