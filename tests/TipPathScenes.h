// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "HyperRedundantArm.h"
#include "PlannerTrial.h"
#include "TinySpatialProblem.h"

namespace narrows
{
inline Eigen::Vector3d tipOf(const SpatialArm &arm, ConfigurationRef q)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement.points.back();
}

/// The tiny arm in space, led by its tip past the ball: over it to where the goal posture has the tip, by two points.
inline Scenario tinyTipPathScenario()
{
    Scenario scenario = tinySpatialScenario();
    SpatialTask &task = scenario.spatial().task;
    const SpatialArm &arm = scenario.spatial().model->arm;
    const Eigen::Vector3d goal = tipOf(arm, std::get<Eigen::VectorXd>(task.goal));
    task.goal = SpatialTipPath{2, {{1.6, 0.0, 1.2}, {0.9, 1.2, 1.2}, goal}, 1e-3};
    scenario.name = "tiny-tip-path";
    return scenario;
}

/// VDSM's manipulator, stretched, whose tip has to go along some points.
inline Scenario manipulatorScenario(const std::vector<Eigen::Vector3d> &points,
                                    const std::vector<SpatialObstacle> &obstacles = {})
{
    SpatialWorld world;
    world.model = std::make_shared<SpatialModel>(SpatialModel{hyperRedundantArm(), obstacles});
    world.task = {Eigen::VectorXd::Zero(17), SpatialTipPath{7, points, 0.1}};
    Scenario scenario;
    scenario.name = "manipulator";
    scenario.world = world;
    return scenario;
}

/// A problem that any first path solves, for one seed.
inline Problem seeded(const Scenario &scenario)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seed);
    Problem problem = makeProblem(scenario);
    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(problem.si);
    objective->setCostThreshold(objective->infiniteCost());
    problem.pdef->setOptimizationObjective(objective);
    return problem;
}

inline Trial spatialTrial(const std::string &planner, const Scenario &scenario,
                          const std::map<std::string, std::string> &parameters = {})
{
    Trial trial{seeded(scenario), nullptr};
    trial.planner = makePlanner(planner, trial.problem.context, parameters);
    trial.planner->setProblemDefinition(trial.problem.pdef);
    trial.planner->setup();
    return trial;
}

/// What the verifier says of the first solution.
inline Verdict verdictOf(const Scenario &scenario, const Trial &trial)
{
    return verify(scenario.world, trial.problem.space->unwrap(trial.path()));
}
}  // namespace narrows
