// SPDX-License-Identifier: BSD-3-Clause
#include "planners/VDSM.h"

#include <cmath>

#include <gtest/gtest.h>

#include "VdsmRun.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

TEST(VDSM, ScalesWhereNothingIsInTheWay)
{
    const VdsmRun run(pipeScenario({}, tipAt(1000.0, 1300.0)));
    expectVerified(run);
    for (const Eigen::VectorXd &values : run.path())
        EXPECT_LT(values.tail(14).lpNorm<Eigen::Infinity>(), 1e-9);  // x_0, theta_1 and alpha_1 only
}

TEST(VDSM, SolvesTheLegsOfTheFirstObstacle)
{
    for (const double z : {600.0, 1300.0})
        expectVerified(VdsmRun(pipeScenario({pipe(700.0, 600.0, 200.0)}, tipAt(1000.0, z))));
}

TEST(VDSM, EveryModeSolvesAnOpenLeg)
{
    for (const std::string mode : {"paper_nearest", "paper_vertical", "branch", "taut"})
        expectVerified(VdsmRun(pipeScenario({pipe(700.0, 600.0, 200.0)}, tipAt(1000.0, -200.0)), {{"mode", mode}}));
}

TEST(VDSM, EndsInTheJointValuesThatAreAskedFor)
{
    const VdsmRun run(tinyPipeScenario());
    expectVerified(run);
    EXPECT_LT((run.path().back() - straightPose(-200.0, 1200.0)).norm(), 1e-12);
    EXPECT_EQ(run.path().front().norm(), 0.0);
}

TEST(VDSM, FollowsATipPath)
{
    const SpatialTipPath path{
        7, {{3126.0, 0.0, -200.0}, {3126.0, 1000.0, -200.0}, {3126.0, 1000.0, 1300.0}, {3126.0, 0.0, 0.0}}, 1e-6};
    const VdsmRun run(pipeScenario({pipe(700.0, 600.0, 200.0)}, path));
    expectVerified(run);
    EXPECT_GT(run.path().size(), 800U);  // every 5 mm
}

TEST(VDSM, KeepsTheWayThatTheStartIsWrapped)
{
    // First around the pipe by one side, then back: the string must not jump to the other side.
    const std::vector<SpatialObstacle> obstacles{pipe(500.0, 0.0, 100.0)};
    const VdsmRun there(
        pipeScenario(obstacles, SpatialTipPath{7, {{3126.0, 300.0, 700.0}, {3126.0, 1100.0, 0.0}}, 1e-6}));
    expectVerified(there);
    Scenario back = pipeScenario(obstacles, tipAt(0.0, 0.0));
    auto &world = std::get<SpatialWorld>(back.world);
    world.task.start = there.path().back();
    const VdsmRun run(back);
    expectVerified(run);
    EXPECT_LE(run.measure("attempts"), 2.0);  // few poses, then all: one string
}

TEST(VDSM, PassesObstaclesOfFiniteLengthBeforeThem)
{
    // Walls across the way of the stretched arm's neighbourhood, but beyond the tip.
    const SpatialObstacle beyond{
        "wall", Box{Eigen::Isometry3d(Eigen::Translation3d(3800.0, 0.0, 400.0)), {300.0, 900.0, 300.0}}};
    expectVerified(VdsmRun(pipeScenario({beyond}, tipAt(300.0, 400.0))));
    // And one that has to be passed on its side.
    const SpatialObstacle between{
        "post", Box{Eigen::Isometry3d(Eigen::Translation3d(2600.0, 400.0, 0.0)), {200.0, 100.0, 100.0}}};
    expectVerified(VdsmRun(pipeScenario({between}, tipAt(800.0, 0.0))));
}

TEST(VDSM, EndsBeforeAnObstacleThatTheArmGoesRound)
{
    // In the section plane the tip is to be near the block, which is 1326 behind it, and the straight arm runs into it.
    const SpatialObstacle block{
        "block", Box{Eigen::Isometry3d(Eigen::Translation3d(1500.0, 500.0, 100.0)), {300.0, 150.0, 150.0}}};
    expectVerified(VdsmRun(pipeScenario({block}, tipAt(560.0, -40.0))));
}

TEST(VDSM, PassesACrossbarInTheTopView)
{
    const SpatialObstacle bar{
        "obs3", Cylinder{{2126.0, 600.0, 0.0}, Vector3d::UnitZ(), 200.0, std::numeric_limits<double>::infinity()}};
    const VdsmRun run(pipeScenario({bar}, SpatialTipPath{7, {{3126.0, 0.0, -200.0}, {3126.0, 1000.0, 1300.0}}, 1e-6}));
    expectVerified(run);
}

TEST(VDSM, WorksInAnyDirectionOfTheSlideAndAnySize)
{
    SpatialWorld world;
    const Vector3d slide(0.96, 0.28, 0.0);
    for (const double sign : {1.0, -1.0})
    {
        world.model = std::make_shared<SpatialModel>(
            SpatialModel{universalChain({0.1, -0.2, 0.3}, {0.5, 0.5, 0.5, 0.4, 0.3}, 0.04,
                                        std::make_pair(Vector3d(sign * slide), Interval{-0.8, 0.8}), 0.7),
                         {{"ball", Sphere{{2.2, 0.95, 0.55}, 0.15}}}});
        world.task.start = Eigen::VectorXd::Zero(11);
        world.task.goal = SpatialTipGoal{4, {2.2, 0.9, 1.0}, 1e-6};
        Scenario scenario;
        scenario.world = world;
        expectVerified(VdsmRun(scenario));
    }
}

TEST(VDSM, NamesWhyItFails)
{
    const VdsmRun reach(pipeScenario({}, tipAt(2000.0, 1500.0)));
    EXPECT_EQ(reach.status, ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(reach.reason(), "reach");
    // 2500 to go, straight on; 2111.9 can be reached.
    EXPECT_NEAR(reach.pdef().getSolutionDifference(), 2500.0 - 2111.9, 5.0);

    const VdsmRun blocked(pipeScenario({pipe(700.0, 600.0, 200.0)}, tipAt(700.0, 500.0)));
    EXPECT_FALSE(blocked.solved());
    EXPECT_EQ(blocked.reason(), "tip_blocked");

    const VdsmRun printed(pipeScenario({pipe(300.0, 500.0, 100.0)}, tipAt(-200.0, 1200.0)),
                          {{"mode", "paper_nearest"}, {"margins", "1"}, {"side_search", "1"}, {"max_jump", "0.5"}});
    EXPECT_FALSE(printed.solved());
    EXPECT_EQ(printed.reason(), "jump");

    const VdsmRun late(pipeScenario({}, tipAt(1000.0, 1300.0)), {}, 4);
    EXPECT_EQ(late.reason(), "timeout");
    EXPECT_NE(late.status, ob::PlannerStatus::EXACT_SOLUTION);
}

TEST(VDSM, PassesOverlappingPipesAsOne)
{
    const VdsmRun run(pipeScenario({pipe(600.0, -150.0, 150.0), pipe(600.0, 150.0, 150.0)}, tipAt(1200.0, 100.0)));
    expectVerified(run);
}

TEST(VDSM, NamesPipesThatEncloseTheBase)
{
    std::vector<SpatialObstacle> ring;
    for (int i = 0; i < 8; ++i)
        ring.push_back(
            pipe(600.0 * std::cos(i * std::acos(0.0) / 2.0), 600.0 * std::sin(i * std::acos(0.0) / 2.0), 200.0));
    const VdsmRun run(pipeScenario(ring, tipAt(1300.0, 0.0)));
    EXPECT_FALSE(run.solved());
    EXPECT_EQ(run.reason(), "overlap");
}

TEST(VDSM, StartsFromAnyPose)
{
    // A pose that no scaling yields, with its tip beyond the reach of scaling.
    Scenario scenario = pipeScenario({pipe(-500.0, 300.0, 150.0)}, tipAt(600.0, 400.0));
    Eigen::VectorXd &start = std::get<SpatialWorld>(scenario.world).task.start;
    start[0] = 500.0;
    for (int i = 0; i < 4; ++i)
        start[2 + 2 * i] = 0.3;
    start[11] = -0.2;
    expectVerified(VdsmRun(scenario));
}

TEST(VDSM, SaysForWhichRobotsItIs)
{
    const Problem planar = tinyProblem();
    EXPECT_NE(whyUnsupported("vdsm", planar.context), "");
    const SpatialModel fixed{universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.1), {}};
    EXPECT_NE(VDSM::whyUnsupported(&fixed), "");
    const SpatialModel across{universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.1,
                                             std::make_pair(Vector3d(Vector3d::UnitY()), Interval{-1.0, 1.0}), 0.7),
                              {}};
    EXPECT_NE(VDSM::whyUnsupported(&across), "");
    const SpatialModel fit{hyperRedundantArm(), {}};
    EXPECT_EQ(VDSM::whyUnsupported(&fit), "");
}

TEST(VDSM, RefusesParametersOutOfRange)
{
    const Problem problem = makeProblem(tinyPipeScenario());
    const std::map<std::string, std::string> bad{{"mode", "paper"},    {"margin", "61"},    {"margins", ""},
                                                 {"side_search", "0"}, {"step", "-1"},      {"max_jump", "-0.1"},
                                                 {"easing", "-1"},     {"retraction", "-5"}};
    for (const auto &[name, value] : bad)
        EXPECT_THROW(makePlanner("vdsm", problem.context, {{name, value}}), ParameterError) << name;
    EXPECT_NO_THROW(makePlanner("vdsm", problem.context, {{"margin", "0"}, {"margins", "1, 2"}}));
}
}  // namespace
}  // namespace narrows
