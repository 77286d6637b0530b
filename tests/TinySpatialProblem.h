// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "scenario/Problem.h"

namespace narrows
{
/// The robot of the tiny scenario with universal joints, and a ball that the straight motion runs into.
inline Scenario tinySpatialScenario()
{
    SpatialWorld world;
    world.model = std::make_shared<SpatialModel>(
        SpatialModel{universalChain({0.0, 0.0, 0.0}, {1.0, 1.0, 0.5}, 0.05, std::nullopt, 1.5),
                     {{"B", Sphere{{1.6, 0.9, 0.0}, 0.4}}}});
    Eigen::VectorXd start(6);
    start << 0.0, 0.1, 0.0, -0.1, 0.0, -0.3;
    Eigen::VectorXd goal(6);
    goal << 0.0, 1.4, 0.0, 0.2, 0.0, -0.6;
    world.task = {start, goal};
    Scenario scenario;
    scenario.name = "tiny-spatial";
    scenario.world = world;
    return scenario;
}
}  // namespace narrows
