// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightManeuvering.h"

#include <gtest/gtest.h>

#include "TightPlannerRun.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

TipGoal tipAt(double x, double y, int link = 2)
{
    return {link, {x, y}, 1e-6};
}

/// A box on the way straight up.
std::vector<PlanarObstacle> boxAhead()
{
    return {wall("box", {-0.5, 0.8}, {0.45, 1.2})};
}

TEST(TightManeuvering, PassesTheUTurnWithLinksNearTheLongest)
{
    // 430 is the exact limit: a link has to lie level across the turn.
    TightPlannerRun run(ladderScenario("U40", "422"));
    ASSERT_EQ(run.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    expectVerified(run);
    EXPECT_GE(run.measure("link_clearance"), 5.0);
    EXPECT_EQ(run.measure("states"), static_cast<double>(run.path().size()));
}

TEST(TightManeuvering, RefusesLinksThatAreTooLongForTheUTurn)
{
    TightPlannerRun run(ladderScenario("U40", "436"), {{"rounds", "100"}});
    EXPECT_EQ(run.solve(), ob::PlannerStatus::ABORT);
    EXPECT_EQ(run.planner->reason(), "chord_clearance");
    EXPECT_FALSE(run.problem.pdef->hasSolution());
    EXPECT_LT(run.measure("link_clearance"), 5.0);
    // One corridor: middle path, the same coarsely, beams, growing, growing finely.
    EXPECT_EQ(run.measure("tries"), 5.0);
    EXPECT_EQ(run.problem.counts->motionChecks, 0U);
}

TEST(TightManeuvering, RelaxesWhereTheBeamsGiveNoWay)
{
    expectRefused(TightPlannerRun(ladderScenario("Z300", "450"), {{"mode", "beams"}}), "chord_clearance");
    expectVerified(TightPlannerRun(ladderScenario("Z300", "450")));
}

TEST(TightManeuvering, FeedsThirtyFiveLinksThroughThirteenBends)
{
    TightPlannerRun run(tightScenario("maze", {{"links", "35"}}));
    EXPECT_TRUE(run.scenario.spatial().model->selfCollision);
    EXPECT_EQ(run.problem.space->getDimension(), 71U);
    ASSERT_EQ(run.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    expectVerified(run);
    EXPECT_EQ(run.measure("states"), static_cast<double>(run.path().size()));
    EXPECT_LT(run.measure("states"), 950.0);
    // All motions are proven, nearly all of them by margins; the validator is asked about hardly more than a tenth.
    EXPECT_EQ(run.measure("motions_by_margin") + run.measure("motions_by_validator"), run.measure("states") - 1.0);
    EXPECT_GT(run.measure("motions_by_margin"), 0.98 * run.measure("states"));
    EXPECT_LT(run.problem.counts->motionChecks, 150U);
}

TEST(TightManeuvering, TriesFurtherCorridorsOnAFinerGrid)
{
    TightPlannerRun run(tightScenario("boxes", {{"length", "170"}}));
    ASSERT_EQ(run.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    expectVerified(run);
    EXPECT_GE(run.measure("corridors"), 2.0);
    expectRefused(TightPlannerRun(tightScenario("boxes", {{"length", "170"}}),
                                  {{"corridors", "1"}, {"rounds", "20"}, {"mode", "middle"}}),
                  "chord_clearance");
}

TEST(TightManeuvering, KeepsJointLimits)
{
    expectVerified(TightPlannerRun(tightScenario("ladder", {{"shape", "L"}, {"length", "150"}, {"max_angle", "50"}})));
    expectRefused(TightPlannerRun(tightScenario("ladder", {{"shape", "L"}, {"length", "350"}, {"max_angle", "20"}}),
                                  {{"mode", "middle"}}),
                  "joint_limit");
}

TEST(TightManeuvering, EveryModeAndFieldSolvesAnEasyScene)
{
    for (const std::string mode : {"relax", "middle", "beams"})
        for (const std::string field : {"corridor", "laplace"})
            expectVerified(TightPlannerRun(ladderScenario("L", "150"), {{"mode", mode}, {"field", field}}));
}

TEST(TightManeuvering, EndsInTheJointValuesThatAreAskedFor)
{
    TightPlannerRun run(tinyChainScenario());
    run.solve();
    expectVerified(run);
    EXPECT_LT((run.path().back() - Eigen::Vector4d(-0.4, 0.7, 1.4, 1.7)).norm(), 1e-12);
}

TEST(TightManeuvering, GoesTheWayRoundThatJointValuesAskFor)
{
    // The tip is above the box, the cheapest way there is by the right, the links are to lie on the left.
    const Eigen::VectorXd left = Eigen::Vector4d(0.0, 2.4, M_PI_2, 0.6);
    expectRefused(TightPlannerRun(chainScenario(boxAhead(), left), {{"corridors", "1"}}), "goal_motion");
    TightPlannerRun run(chainScenario(boxAhead(), left));
    run.solve();
    expectVerified(run);
    EXPECT_GE(run.measure("corridors"), 2.0);
}

TEST(TightManeuvering, SameProblemSamePath)
{
    for (const Scenario &scenario : {ladderScenario("U40", "415"), tightScenario("maze_prefix", {{"length", "51.7"}})})
    {
        TightPlannerRun first(scenario);
        TightPlannerRun second(scenario);
        ASSERT_EQ(first.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        ASSERT_EQ(second.solve(), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(first.path(), second.path());
        EXPECT_EQ(first.planner->measures(), second.planner->measures());
        EXPECT_EQ(first.problem.counts->motionChecks, second.problem.counts->motionChecks);
    }
}

TEST(TightManeuvering, GoesOnWhereverItWasInterrupted)
{
    const std::map<std::string, Scenario> scenarios{{"relax", ladderScenario("Z300", "450")},
                                                    {"middle", ladderScenario("L", "150")}};
    for (const auto &[mode, scenario] : scenarios)
    {
        TightPlannerRun whole(scenario, {{"mode", mode}});
        const Counter asked = counter();
        whole.planner->solve(questions(10'000'000, asked));
        const long all = *asked;
        for (const long patience : {1L, 2L, all / 4, all / 2, all - 2})
        {
            TightPlannerRun run(scenario, {{"mode", mode}});
            EXPECT_EQ(run.solve(patience), ob::PlannerStatus::TIMEOUT) << mode << " " << patience;
            EXPECT_EQ(run.planner->reason(), "timeout");
            ASSERT_EQ(run.solve(), ob::PlannerStatus::EXACT_SOLUTION) << mode << " " << patience;
            EXPECT_EQ(run.path(), whole.path()) << mode << " " << patience;
        }
    }
}

TEST(TightManeuvering, ClearForgetsEverythingButParameters)
{
    TightPlannerRun run(ladderScenario("Z300", "450"), {{"rounds", "300"}});
    run.solve();
    const std::vector<Eigen::VectorXd> path = run.path();
    const std::map<std::string, double> measures = run.planner->measures();
    run.planner->clear();
    run.problem.pdef->clearSolutionPaths();
    EXPECT_TRUE(run.planner->measures().empty());
    ob::PlannerData data(run.problem.si);
    run.planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), 0U);
    EXPECT_EQ(run.planner->getRounds(), 300);
    run.solve();
    EXPECT_EQ(run.path(), path);
    EXPECT_EQ(run.planner->measures(), measures);
}

TEST(TightManeuvering, NamesAGoalThatIsWalledOff)
{
    const std::vector<PlanarObstacle> ring{wall("left", {1.0, 1.0}, {1.2, 3.0}), wall("right", {2.8, 1.0}, {3.0, 3.0}),
                                           wall("below", {1.0, 1.0}, {3.0, 1.2}),
                                           wall("above", {1.0, 2.8}, {3.0, 3.0})};
    expectRefused(TightPlannerRun(chainScenario(ring, tipAt(2.0, 2.0))), "no_corridor");
    expectRefused(TightPlannerRun(chainScenario(ring, tipAt(2.0, 2.0)), {{"field", "laplace"}}), "no_corridor");
}

TEST(TightManeuvering, NamesAStartThatIsNotStraightOnItsSlide)
{
    Scenario bent = chainScenario({}, tipAt(0.5, 1.0));
    bent.planar().task.start[3] = 1.0;
    expectRefused(TightPlannerRun(bent), "start_not_straight");
    Scenario across = chainScenario({}, tipAt(0.5, 1.0));
    across.planar().task.start.tail(3).setConstant(1.0);
    expectRefused(TightPlannerRun(across), "start_not_straight");
}

TEST(TightManeuvering, IsFedStraightOnWhereItIsTooShortToReachBack)
{
    // Base and tip can be 3 apart, start and goal of the tip are further: the base has to come past y = 0.
    const Scenario scenario = chainScenario({wall("box", {-0.5, 1.8}, {0.3, 2.4})}, tipAt(0.6, 3.3));
    for (const std::string field : {"corridor", "laplace"})
    {
        TightPlannerRun run(scenario, {{"field", field}});
        run.solve();
        expectVerified(run);
        EXPECT_EQ(run.measure("tries"), 1.0) << field;
    }
    // The duct's first bends, 200 before which the tip begins.
    expectVerified(TightPlannerRun(tightScenario("maze_prefix", {{"links", "3"}, {"length", "51.7"}})));
    // Here only the relaxed path turns out too long.
    TightPlannerRun longer(tightScenario("maze_prefix", {{"links", "8"}, {"length", "82.8"}}));
    longer.solve();
    expectVerified(longer);
    EXPECT_GT(longer.measure("tries"), 5.0);
}

TEST(TightManeuvering, NamesASlideThatIsTooShort)
{
    // The base would have to come to about y = -0.6.
    Scenario scenario = chainScenario(boxAhead(), tipAt(0.7, 2.0));
    const PlanarModel model = *scenario.planar().model;
    const PlanarArm arm(model.arm.base(), model.arm.links(), model.arm.radius(), Slide{{0.0, 1.0}, -4.0, -1.5});
    scenario.planar().model = std::make_shared<PlanarModel>(PlanarModel{arm, model.obstacles, true});
    expectRefused(TightPlannerRun(scenario, {{"corridors", "1"}}), "slide_limit");
}

TEST(TightManeuvering, NamesGoalsThatItDoesNotKnow)
{
    TightPlannerRun run(chainScenario({}, tipAt(0.5, 0.5, 1)));
    EXPECT_EQ(run.solve(), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
}

TEST(TightManeuvering, SaysForWhichRobotsItIs)
{
    const auto why = [](const PlanarArm &arm)
    {
        const PlanarModel model{arm, {}};
        return TightManeuvering::whyUnsupported(&model, nullptr);
    };
    const Slide slide{{0.0, 1.0}, -1.0, 1.0};
    EXPECT_EQ(why({{0.0, 0.0}, {{1.0, -1}, {1.0, 0}}, 0.1, slide}), "");
    EXPECT_NE(why({{0.0, 0.0}, {{1.0, -1}, {1.0, 0}}, 0.1}).find("slide"), std::string::npos);
    EXPECT_NE(why({{0.0, 0.0}, {{1.0, -1}, {1.0, 0}, {1.0, 0}}, 0.1, slide}).find("tree"), std::string::npos);
    EXPECT_NE(why({{0.0, 0.0}, {{1.0, -1}, {1.1, 0}}, 0.1, slide}).find("one length"), std::string::npos);
    const SpatialModel fixed{universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.1), {}};
    EXPECT_NE(TightManeuvering::whyUnsupported(nullptr, &fixed).find("slide"), std::string::npos);
    EXPECT_NE(TightManeuvering::whyUnsupported(nullptr, nullptr), "");
    const Problem tiny = tinyProblem();
    EXPECT_THROW(makePlanner("tight", tiny.context), std::invalid_argument);
}

TEST(TightManeuvering, RefusesParametersOutOfRange)
{
    const Problem problem = makeProblem(tinyChainScenario());
    const std::vector<std::pair<std::string, std::string>> bad{
        {"mode", "paper"},    {"field", "distance"}, {"spacing", "-1"}, {"corridors", "0"}, {"corridors", "65"},
        {"refinements", "5"}, {"rounds", "0"},       {"couples", "0"},  {"couples", "5"},   {"refinements", "-1"}};
    for (const auto &[name, value] : bad)
        EXPECT_THROW(makePlanner("tight", problem.context, {{name, value}}), ParameterError) << name << " " << value;
    EXPECT_NO_THROW(makePlanner("tight", problem.context, {{"spacing", "0.1"}, {"couples", "4"}}));
}
}  // namespace
}  // namespace narrows
