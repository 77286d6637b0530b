// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scenario/Problem.h"

namespace narrows
{
/// An axis-parallel box of the plane.
inline PlanarObstacle wall(const std::string &name, const Eigen::Vector2d &lower, const Eigen::Vector2d &upper)
{
    return {name, Polygon{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}}};
}

/// Three unit links, half-width 0.05, on a slide along y: straight below the origin, where their tip is.
inline Scenario chainScenario(std::vector<PlanarObstacle> obstacles, decltype(PlanarTask::goal) goal)
{
    Scenario scenario;
    scenario.name = "chain";
    const PlanarArm arm({0.0, 0.0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}}, 0.05, Slide{{0.0, 1.0}, -4.0, 1.0});
    scenario.planar().model = std::make_shared<PlanarModel>(PlanarModel{arm, std::move(obstacles), true});
    scenario.planar().task.start = Eigen::Vector4d(-3.0, M_PI_2, M_PI_2, M_PI_2);
    scenario.planar().task.goal = std::move(goal);
    scenario.planar().task.limits.angles.resize(3);
    return scenario;
}

/// From the straight chain to joint values beside a box that the straight motion runs into.
inline Scenario tinyChainScenario()
{
    const Eigen::VectorXd goal = Eigen::Vector4d(-0.4, 0.7, 1.4, 1.7);
    return chainScenario({wall("box", {-0.5, 0.8}, {0.45, 1.2})}, goal);
}
}  // namespace narrows
