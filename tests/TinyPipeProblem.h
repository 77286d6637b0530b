// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>

#include "HyperRedundantArm.h"
#include "scenario/Problem.h"

namespace narrows
{
/// A cylinder without ends along x, the slide of the hyper-redundant arm.
inline SpatialObstacle pipe(double y, double z, double radius)
{
    return {"pipe " + std::to_string(y) + " " + std::to_string(z),
            Cylinder{{0.0, y, z}, Eigen::Vector3d::UnitX(), radius, std::numeric_limits<double>::infinity()}};
}

/// The hyper-redundant arm, stretched at first.
inline Scenario pipeScenario(std::vector<SpatialObstacle> obstacles, decltype(SpatialTask::goal) goal)
{
    SpatialWorld world;
    world.model = std::make_shared<SpatialModel>(SpatialModel{hyperRedundantArm(), std::move(obstacles)});
    world.task.start = Eigen::VectorXd::Zero(17);
    world.task.goal = std::move(goal);
    Scenario scenario;
    scenario.name = "pipes";
    scenario.world = world;
    return scenario;
}

/// Joint values of the straight arm whose tip is at (3126, y, z).
inline Eigen::VectorXd straightPose(double y, double z)
{
    const ChainGeometry chain = *chainGeometry(hyperRedundantArm());
    double reach = 0.0;
    for (const double length : chain.lengths)
        reach += length;
    const Eigen::Vector3d tip(reach, y, z);
    const Eigen::Vector3d base(reach - std::sqrt(reach * reach - y * y - z * z), 0.0, 0.0);
    std::vector<Eigen::Vector3d> centres{base};
    double along = 0.0;
    for (const double length : chain.lengths)
    {
        along += length;
        centres.push_back(base + along / reach * (tip - base));
    }
    Eigen::VectorXd values;
    valuesFromCentres(chain, centres, values);
    return values;
}

/// From the stretched arm to a straight one beyond a pipe that the way there runs into.
inline Scenario tinyPipeScenario()
{
    return pipeScenario({pipe(300.0, 500.0, 100.0)}, straightPose(-200.0, 1200.0));
}
}  // namespace narrows
