// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialTaskReader.h"

#include <algorithm>

#include "scenario/SpatialStateReader.h"
#include "scenario/TipReach.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostTips = 10000;

std::optional<Eigen::VectorXd> readStart(const Field &field, const SpatialRobotDraft &robot)
{
    const Mapping start(field);
    start.allowOnly({"joints", "slide"});
    start.required("joints");
    return readSpatialState(start, robot);
}

TipReach reachOf(const SpatialArm &arm, const SpatialTipGoal &goal, int entry)
{
    std::vector<double> lengths;
    for (int i = 0; i <= goal.link; ++i)
        lengths.push_back(
            (arm.links()[static_cast<std::size_t>(i)].to - arm.links()[static_cast<std::size_t>(i)].from).norm());
    const SpatialJoint &first = arm.joints().front();
    const Eigen::Vector3d base = first.offset.translation();
    TipReach reach{lengths, base, base, goal.point, goal.tolerance, entry};
    if (first.kind == SpatialJoint::Kind::Prismatic)
    {
        const Eigen::Vector3d axis = first.offset.linear() * first.axis;
        reach.baseFrom += first.limits->lower * axis;
        reach.baseTo += first.limits->upper * axis;
    }
    return reach;
}

/// The entry of `links` whose end is meant, from 1: the last that has a length unless the goal names one. 0 (and a
/// fault) if it is not sound.
int readEntry(const Field &field, const SpatialRobotDraft &robot)
{
    if (!field.given())
    {
        const auto last = std::find_if(robot.tips.rbegin(), robot.tips.rend(), [](int link) { return link >= 0; });
        return static_cast<int>(robot.tips.rend() - last);
    }
    if (robot.entryCount == 0)
        return 0;
    const int entry = field.integer(1, robot.entryCount).value_or(0);
    if (entry == 0 || robot.tips[static_cast<std::size_t>(entry - 1)] >= 0)
        return entry;
    field.fault("has no length of its own (neither d nor a), so that it has no tip");
    return 0;
}

std::optional<SpatialTipGoal> readTipGoal(const Mapping &goal, const SpatialRobotDraft &robot)
{
    goal.allowOnly({"tip", "tolerance", "link"});
    const std::optional<Eigen::Vector3d> point = goal.required("tip").spatialPoint();
    const std::optional<double> tolerance = goal.required("tolerance").positive();
    const int entry = readEntry(goal.optional("link"), robot);
    if (!point || !tolerance || entry == 0 || !robot.arm)
        return std::nullopt;
    const SpatialTipGoal tip{robot.tips[static_cast<std::size_t>(entry - 1)], *point, *tolerance};
    checkReach(goal.optional("tip"), reachOf(*robot.arm, tip, entry));
    return tip;
}

std::optional<SpatialTipPath> readTipPath(const Mapping &goal, const SpatialRobotDraft &robot)
{
    goal.allowOnly({"tip_path", "tolerance", "link"});
    const std::vector<Field> items = goal.optional("tip_path").items(1, mostTips);
    const std::optional<double> tolerance = goal.required("tolerance").positive();
    const int entry = readEntry(goal.optional("link"), robot);
    SpatialTipPath path{0, {}, tolerance.value_or(0.0)};
    for (const Field &item : items)
        if (const std::optional<Eigen::Vector3d> point = item.spatialPoint())
            path.points.push_back(*point);
    if (items.empty() || path.points.size() != items.size() || !tolerance || entry == 0 || !robot.arm)
        return std::nullopt;
    path.link = robot.tips[static_cast<std::size_t>(entry - 1)];
    for (std::size_t i = 0; i < items.size(); ++i)
        checkReach(items[i], reachOf(*robot.arm, {path.link, path.points[i], path.tolerance}, entry));
    return path;
}

std::optional<decltype(SpatialTask::goal)> readGoal(const Field &field, const SpatialRobotDraft &robot)
{
    const Mapping goal(field);
    if (goal.has("tip"))
        return readTipGoal(goal, robot);
    if (goal.has("tip_path"))
        return readTipPath(goal, robot);
    goal.allowOnly({"joints", "slide", "tip", "tip_path"});
    if (goal.valid() && !goal.has("joints"))
        field.fault("must have joints, tip or tip_path");
    return readSpatialState(goal, robot);
}
}  // namespace

std::optional<SpatialTask> readSpatialTask(const Field &start, const Field &goal, const SpatialRobotDraft &robot)
{
    const std::optional<Eigen::VectorXd> from = readStart(start, robot);
    const auto to = readGoal(goal, robot);
    if (!from || !to)
        return std::nullopt;
    return SpatialTask{*from, *to};
}
}  // namespace narrows
