// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TipFollower.h"

#include <cmath>

#include <gtest/gtest.h>

#include "SpatialRobots.h"
#include "TipPathScenes.h"
#include "kernel/PathMeasures.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

const ModelPlanner &model(const Trial &trial)
{
    return static_cast<const ModelPlanner &>(*trial.planner);
}

PathMeasures measured(const Scenario &scenario, const Trial &trial)
{
    const SpatialWorld &world = scenario.spatial();
    return measurePath(world.model->arm, world.task, trial.problem.space->unwrap(trial.path()));
}

class EveryFollower : public testing::TestWithParam<std::string>
{
};

TEST_P(EveryFollower, TakesTheTipAlongItsPath)
{
    const Scenario scenario = manipulatorScenario({{3126.0, 0.0, -200.0}, {3126.0, 300.0, -200.0}});
    const Trial trial = spatialTrial(GetParam(), scenario, {{"step", "5"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    const Verdict verdict = verdictOf(scenario, trial);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(model(trial).measures().at("waypoints"), 40.0 + 60.0);
    EXPECT_EQ(model(trial).measures().at("points_reached"), 2.0);
    EXPECT_GE(model(trial).measures().at("iterations"), 200.0);
    EXPECT_EQ(trial.path().getStateCount(), 101U);
    const PathMeasures measures = measured(scenario, trial);
    EXPECT_LT(measures.tipDeviation.value(), 0.1);
    EXPECT_NEAR(measures.tipLength, 500.0, 0.1);
    EXPECT_LT(measures.largestBend.value(), hyperRedundantBend);
    EXPECT_GE(measures.movedJoints, 4);
}

TEST_P(EveryFollower, GoesStraightToATipGoal)
{
    Scenario scenario = manipulatorScenario({});
    scenario.spatial().task.goal = SpatialTipGoal{7, {3000.0, 100.0, 50.0}, 0.5};
    const Trial trial = spatialTrial(GetParam(), scenario, {{"step", "20"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    EXPECT_TRUE(verdictOf(scenario, trial).accepted);
    EXPECT_EQ(model(trial).measures().at("waypoints"), std::ceil(std::sqrt(126.0 * 126.0 + 12500.0) / 20.0));
}

TEST_P(EveryFollower, FollowsWithAnyArmInSpace)
{
    SpatialWorld world;
    const SpatialArm arm = sixAxisArm();
    world.model = std::make_shared<SpatialModel>(SpatialModel{arm, {{"ball", Sphere{{3.0, 3.0, 3.0}, 0.5}}}});
    world.task.start = Eigen::VectorXd::Constant(6, 0.4);
    const Vector3d from = tipOf(arm, world.task.start);
    world.task.goal =
        SpatialTipPath{arm.linkCount() - 1, {from + Vector3d(0.0, 0.05, 0.0), from + Vector3d(0.0, 0.0, -0.05)}, 1e-3};
    Scenario scenario;
    scenario.name = "six-axis";
    scenario.world = world;
    const Trial trial = spatialTrial(GetParam(), scenario, {{"step", "0.01"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    const Verdict verdict = verdictOf(scenario, trial);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
}

TEST_P(EveryFollower, NamesALimitWhenTheSlideEnds)
{
    const Scenario scenario = manipulatorScenario({{4500.0, 0.0, 0.0}});
    const Trial trial = spatialTrial(GetParam(), scenario, {{"step", "50"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(model(trial).reason(), "limit");
    EXPECT_EQ(model(trial).measures().at("points_reached"), 0.0);
    const Eigen::VectorXd last = trial.problem.space->unwrap(trial.path()).back();
    EXPECT_NEAR(tipOf(scenario.spatial().model->arm, last).x(), 4126.0, 51.0);
    EXPECT_LE(last[0], 1000.0);
    EXPECT_NEAR(trial.problem.pdef->getSolutionDifference(), 4500.0 - 4126.0, 51.0);
}

TEST_P(EveryFollower, NamesACollision)
{
    // A plate right through the tip's way.
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vector3d(3126.0, 400.0, 0.0);
    const Scenario scenario =
        manipulatorScenario({{3126.0, 800.0, 0.0}}, {{"plate", Box{pose, {2000.0, 20.0, 2000.0}}}});
    const Trial trial = spatialTrial(GetParam(), scenario, {{"step", "10"}});
    const ob::PlannerStatus status = trial.planner->solve(questions(1000));
    ASSERT_EQ(type(status), ob::PlannerStatus::APPROXIMATE_SOLUTION) << status.asString();
    // Who knows of the plate stops before it.
    EXPECT_EQ(model(trial).reason(), GetParam() == "iknlopt" ? "no_convergence" : "collision");
    const double y = tipOf(scenario.spatial().model->arm, trial.problem.space->unwrap(trial.path()).back()).y();
    EXPECT_LT(y, 400.0 - 20.0 - 61.5);
    EXPECT_GT(y, 250.0);
    // The prefix is free.
    SpatialWorld prefix = scenario.spatial();
    prefix.task.goal = trial.problem.space->unwrap(trial.path()).back();
    EXPECT_EQ(verify(World(prefix), trial.problem.space->unwrap(trial.path())).reason, "");
}

INSTANTIATE_TEST_SUITE_P(All, EveryFollower, testing::Values("ikdls", "ikprojection", "iknlopt"),
                         [](const auto &planner) { return planner.param; });

TEST(TipFollower, NamesAnIterationThatDoesNotConverge)
{
    const Trial trial =
        spatialTrial("ikdls", manipulatorScenario({{3126.0, 500.0, 0.0}}), {{"max_iterations", "1"}, {"step", "5"}});
    EXPECT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::ABORT);
    EXPECT_EQ(model(trial).reason(), "no_convergence");
    EXPECT_FALSE(trial.problem.pdef->hasSolution());
    EXPECT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::ABORT) << "nothing has changed";
}

TEST(TipFollower, GoesOnWhereItsTimeEnded)
{
    const Scenario scenario = manipulatorScenario({{3126.0, 500.0, 0.0}});
    const Trial whole = spatialTrial("ikdls", scenario, {{"step", "10"}});
    whole.planner->solve(questions(1000));
    const Trial parts = spatialTrial("ikdls", scenario, {{"step", "10"}});
    ASSERT_EQ(type(parts.planner->solve(questions(20))), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(model(parts).reason(), "");
    EXPECT_EQ(model(parts).measures().at("waypoints"), 20.0);
    EXPECT_NEAR(parts.problem.pdef->getSolutionDifference(), 300.0, 1e-9);
    ASSERT_EQ(type(parts.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(parts.problem.space->unwrap(parts.path()), whole.problem.space->unwrap(whole.path()));
}

/// A ball beside the arm, which the arm meets when its tip goes to that side, and can pass above.
Scenario ballScenario()
{
    return manipulatorScenario({{3126.0, 700.0, 0.0}}, {{"ball", Sphere{{1700.0, 330.0, -110.0}, 100.0}}});
}

TEST(TipFollower, IsBlindForObstaclesByDampedLeastSquares)
{
    const Trial trial = spatialTrial("ikdls", ballScenario());
    EXPECT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(model(trial).reason(), "collision");
}

TEST(TipFollower, KeepsAwayFromObstaclesInTheNullSpace)
{
    const Scenario scenario = ballScenario();
    const Trial trial = spatialTrial("ikprojection", scenario);
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    EXPECT_TRUE(verdictOf(scenario, trial).accepted);
}

TEST(TipFollower, KeepsItsMarginByOptimization)
{
    const Scenario scenario = ballScenario();
    const Trial trial = spatialTrial("iknlopt", scenario, {{"margin", "10"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    const Verdict verdict = verdictOf(scenario, trial);
    ASSERT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_GT(verdict.clearance, 9.9);
    EXPECT_LT(verdict.clearance, 10.1);
}

TEST(TipFollower, OptimizesWithoutDerivativesToo)
{
    const Scenario scenario = manipulatorScenario({{3126.0, 20.0, 0.0}});
    const Trial trial = spatialTrial("iknlopt", scenario, {{"algorithm", "cobyla"}, {"step", "10"}});
    ASSERT_EQ(type(trial.planner->solve(questions(1000))), ob::PlannerStatus::EXACT_SOLUTION) << model(trial).reason();
    EXPECT_TRUE(verdictOf(scenario, trial).accepted);
}

TEST(TipFollower, ComesBackToItsPostureByGradientProjectionAlone)
{
    const Scenario scenario = manipulatorScenario(
        {{3126.0, 0.0, -200.0}, {3126.0, 1000.0, -200.0}, {3126.0, 1000.0, 1300.0}, {3126.0, 0.0, 0.0}});
    const auto closureOf = [&](const std::string &planner)
    {
        const Trial trial = spatialTrial(planner, scenario);
        EXPECT_EQ(type(trial.planner->solve(questions(2000))), ob::PlannerStatus::EXACT_SOLUTION);
        return measured(scenario, trial).closure.value();
    };
    EXPECT_LT(closureOf("ikprojection"), 1e-3);
    EXPECT_GT(closureOf("ikdls"), 5e-3);
    EXPECT_GT(closureOf("iknlopt"), 5e-3);
}

TEST(TipFollower, RefusesParametersOutOfRange)
{
    const Problem problem = seeded(manipulatorScenario({{3126.0, 1.0, 0.0}}));
    const std::vector<std::tuple<std::string, std::string, std::string>> bad{{"ikdls", "step", "0"},
                                                                             {"ikdls", "step", "1e-9"},
                                                                             {"ikdls", "precision", "0"},
                                                                             {"ikdls", "precision", "1.5"},
                                                                             {"ikdls", "max_iterations", "0"},
                                                                             {"ikdls", "max_iterations", "1001"},
                                                                             {"ikdls", "lambda", "0"},
                                                                             {"ikdls", "null_steps", "1"},
                                                                             {"ikprojection", "null_steps", "0"},
                                                                             {"ikprojection", "bend_gain", "2"},
                                                                             {"ikprojection", "obstacle_gain", "-1"},
                                                                             {"ikprojection", "influence", "-1"},
                                                                             {"iknlopt", "margin", "-1"},
                                                                             {"iknlopt", "algorithm", "newton"}};
    for (const auto &[planner, name, value] : bad)
        EXPECT_THROW(makePlanner(planner, problem.context, {{name, value}}), ParameterError) << planner << '.' << name;
}

TEST(TipFollower, IsForTipsOfRobotsInSpace)
{
    EXPECT_FALSE(whyUnsupported("ikdls", seededProblem().context).empty());
    EXPECT_TRUE(whyUnsupported("ikdls", seeded(tinySpatialScenario()).context).empty());
    const Trial trial = spatialTrial("ikdls", tinySpatialScenario());
    EXPECT_EQ(type(trial.planner->solve(questions(10))), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}
}  // namespace
}  // namespace narrows
