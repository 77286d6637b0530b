// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <string>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "scenario/Problem.h"

namespace narrows
{
/// Three links and one circle that the straight motion runs into: milliseconds for any planner.
inline Scenario tinyScenario()
{
    Scenario scenario;
    scenario.name = "tiny";
    scenario.planar().model = std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0.0, 0.0}, {{1.0, -1}, {1.0, 0}, {0.5, 1}}), {{"C", Circle{{1.6, 0.9}, 0.4}}}});
    scenario.planar().task.start = Eigen::Vector3d(0.1, 0.0, -0.3);
    scenario.planar().task.goal = Eigen::VectorXd(Eigen::Vector3d(1.4, 1.6, 1.0));
    scenario.planar().task.limits.angles.resize(3);
    scenario.planar().convention = AngleConvention::Absolute;
    return scenario;
}

/// The tiny scenario as a problem that any first path solves, so that optimizing planners stop there too.
inline Problem tinyProblem(const std::string &space = "absolute")
{
    Problem problem = makeProblem(tinyScenario(), {"analytic", "continuous", space});
    auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(problem.si);
    objective->setCostThreshold(ob::Cost(std::numeric_limits<double>::infinity()));
    problem.pdef->setOptimizationObjective(objective);
    return problem;
}
}  // namespace narrows
