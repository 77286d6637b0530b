// SPDX-License-Identifier: BSD-3-Clause
// Robots in space through the whole program: problem, planners, run, verdict, path file.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>

#include "TipPathScenes.h"
#include "benchmark/PathFile.h"
#include "benchmark/RunOnce.h"
#include "planners/ArmDecomposition.h"
#include "planners/PlannerFactory.h"
#include "spaces/SpatialArmStateSpace.h"
#include "spaces/TipGoalRegion.h"

namespace narrows
{
namespace
{
RunSpec specOf(const Scenario &scenario, const std::string &planner, const std::string &checker = "analytic")
{
    RunSpec spec;
    spec.instance = scenario.name;
    spec.scenario = std::make_shared<const Scenario>(scenario);
    spec.problem.checker = checker;
    spec.planner = spec.label = planner;
    spec.seed = 4;
    spec.timeLimit = 5.0;
    return spec;
}

Scenario tinyTipScenario()
{
    Scenario scenario = tinySpatialScenario();
    SpatialTask &task = scenario.spatial().task;
    SpatialArm::Placement placement;
    scenario.spatial().model->arm.place(std::get<Eigen::VectorXd>(task.goal), placement);
    task.goal = SpatialTipGoal{2, placement.points.back(), 1e-3};
    return scenario;
}

TEST(SpatialProblem, HoldsWhatTheScenarioSays)
{
    const Scenario scenario = tinySpatialScenario();
    const Problem problem = makeProblem(scenario);
    const auto &space = dynamic_cast<const SpatialArmStateSpace &>(*problem.space);
    EXPECT_EQ(space.arm().linkCount(), 3);
    Eigen::VectorXd q;
    space.toConfiguration(problem.pdef->getStartState(0), q);
    EXPECT_EQ(q, scenario.spatial().task.start);
    EXPECT_TRUE(problem.si->isValid(problem.pdef->getStartState(0)));
    const ob::State *goal = problem.pdef->getGoal()->as<ob::GoalState>()->getState();
    EXPECT_TRUE(problem.si->isValid(goal));
    EXPECT_FALSE(problem.si->checkMotion(problem.pdef->getStartState(0), goal)) << "the ball is in the way";
    EXPECT_EQ(problem.context.planar, nullptr);
    ASSERT_TRUE(problem.context.repulsion);
    EXPECT_EQ(problem.context.repulsion()->dimension(), 6);
}

TEST(SpatialProblem, HasNoAbsoluteAngles)
{
    const Scenario scenario = tinySpatialScenario();
    for (const char *space : {"absolute", "absolute_line", "no_such_space"})
        EXPECT_THROW(makeProblem(scenario, {"analytic", "continuous", space}), std::invalid_argument) << space;
    for (const char *space : {"scenario", "relative", "relative_line"})
        EXPECT_NO_THROW(makeProblem(scenario, {"analytic", "continuous", space})) << space;
}

class SpatialRun : public testing::TestWithParam<std::string>
{
};

TEST_P(SpatialRun, EndsInAVerifiedPath)
{
    const RunSpec spec = specOf(tinySpatialScenario(), "rrtconnect", GetParam());
    const Record record = runOnce(spec);
    ASSERT_EQ(record.outcome, Outcome::Solved) << record.reason;
    EXPECT_EQ(record.path.front(), spec.scenario->spatial().task.start);
    EXPECT_GT(record.clearance.value(), 0.0);
    EXPECT_GT(record.maxJointStep.value(), 0.0);
}

TEST_P(SpatialRun, ReachesATip)
{
    const Record record = runOnce(specOf(tinyTipScenario(), "rrtconnect", GetParam()));
    EXPECT_EQ(record.outcome, Outcome::Solved) << record.reason;
}

INSTANTIATE_TEST_SUITE_P(Checkers, SpatialRun, testing::Values("analytic", "fcl"),
                         [](const auto &checker) { return checker.param; });

TEST(SpatialRunRecord, IsUnsupportedForPlannersOfOtherRobots)
{
    const Record record = runOnce(specOf(tinySpatialScenario(), "tight"));
    EXPECT_EQ(record.outcome, Outcome::Unsupported);
    EXPECT_FALSE(record.reason.empty());
}

/// A chain whose slide is much longer than itself: the grid is around where the slide takes it.
TEST(SpatialDecomposition, SamplesStatesWhoseTipsAreInTheCell)
{
    Scenario scenario = tinySpatialScenario();
    const auto slide = std::make_pair(Eigen::Vector3d(0.0, 0.6, 0.8), Interval{-50.0, -40.0});
    scenario.spatial().model =
        std::make_shared<SpatialModel>(SpatialModel{universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.05, slide, 1.5), {}});
    Eigen::VectorXd at = Eigen::VectorXd::Zero(5);
    at[0] = -45.2;
    scenario.spatial().task = {at, at};
    const Problem problem = makeProblem(scenario);
    const ArmDecomposition<SpatialArmStateSpace> cells(problem.si);
    EXPECT_EQ(cells.getDimension(), 3);
    EXPECT_EQ(cells.getNumRegions(), 16 * 16 * 16);
    // Tips are in the box around the slide, 0 by 6 by 8, and by 1.001 * 2.05 beyond it.
    const double across = 2.0 * 1.001 * 2.05 / 16.0;
    std::vector<int> cell;
    const ob::State *start = problem.pdef->getStartState(0);
    cells.ridToGridCell(cells.locateRegion(start), cell);
    EXPECT_EQ(cell[0], static_cast<int>((2.0 + 1.001 * 2.05) / across));
    EXPECT_EQ(cell[1], 7) << "a little before the middle";
    EXPECT_EQ(cell[2], 7);
    ob::ScopedState<> state(problem.si);
    for (const ob::State *seed : {start, static_cast<const ob::State *>(nullptr)})
    {
        int found = 0;
        for (int k = 0; k < 20; ++k)
            if (cells.sampleFromRegion(cells.gridCellToRid({10, 8, 8}), state.get(), seed))
            {
                ++found;
                EXPECT_EQ(cells.locateRegion(state.get()), cells.gridCellToRid({10, 8, 8}));
                EXPECT_TRUE(problem.si->isValid(state.get()));
            }
        EXPECT_GT(found, 10);
    }
    EXPECT_THROW(ArmDecomposition<PlanarArmStateSpace>{problem.si}, std::invalid_argument);
}

TEST(SpatialDecomposition, LeadsXxlPastABall)
{
    for (const Scenario &scenario : {tinySpatialScenario(), tinyTipScenario()})
    {
        const Record record = runOnce(specOf(scenario, "xxl"));
        EXPECT_EQ(record.outcome, Outcome::Solved) << record.reason;
    }
}

TEST(SpatialRunRecord, TellsHowATipPathWasFollowed)
{
    const Record led = runOnce(specOf(tinyTipPathScenario(), "rrtconnect"));
    ASSERT_EQ(led.outcome, Outcome::Solved) << led.reason;
    EXPECT_FALSE(led.usesModel);
    EXPECT_EQ(led.measures.at("points_reached"), 3.0);
    EXPECT_GT(led.tipDeviation.value(), 0.05) << "it goes as it likes between the points";
    EXPECT_LE(led.largestBend.value(), 1.5);
    EXPECT_FALSE(led.closure);

    const Scenario square = manipulatorScenario({{3126.0, 0.0, -200.0}, {3126.0, 200.0, -200.0}, {3126.0, 0.0, 0.0}});
    const RunSpec spec = specOf(square, "ikdls");
    const Record record = runOnce(spec);
    ASSERT_EQ(record.outcome, Outcome::Solved) << record.reason;
    EXPECT_TRUE(record.usesModel);
    EXPECT_LT(record.tipDeviation.value(), 0.2);
    EXPECT_NEAR(record.tipLength.value(), 400.0 + 200.0 * std::sqrt(2.0), 1.0);
    EXPECT_EQ(record.movedJoints.value(), 16) << "damped least squares moves them all";
    EXPECT_GT(record.closure.value(), 0.0);
    const Record again = recordFromJson(toJson(spec, record));
    EXPECT_EQ(again.tipDeviation, record.tipDeviation);
    EXPECT_EQ(again.closure, record.closure);
    EXPECT_EQ(again.movedJoints, record.movedJoints);
}

TEST(SpatialRunRecord, CanBeReadBackAndVerified)
{
    const RunSpec spec = specOf(tinySpatialScenario(), "rrtconnect");
    const Record record = runOnce(spec);
    const std::string file = testing::TempDir() + "spatial_path.json";
    std::ofstream(file) << toJson(spec, record);
    const std::vector<Eigen::VectorXd> path = readPathFile(file, *spec.scenario);
    std::filesystem::remove(file);
    EXPECT_EQ(path, record.path);
    EXPECT_TRUE(verify(spec.scenario->world, path).accepted);
    std::vector<Eigen::VectorXd> straight{path.front(), path.back()};
    EXPECT_EQ(verify(spec.scenario->world, straight).reason, "collision");
}

/// What planners do in space differs from the plane in nothing but the space.
TEST(SpatialPlanners, PathsThatTheyCallExactAreVerified)
{
    int solved = 0;
    for (const char *planner : {"bkpiece1", "biest", "est", "hppm", "kpiece1", "lbkpiece1", "pdst", "prmstar",
                                "projest", "rrt", "rrtconnect", "rrtstar", "sbl", "stride"})
    {
        const Record record = runOnce(specOf(tinySpatialScenario(), planner));
        EXPECT_NE(record.outcome, Outcome::Unverified) << planner << ": " << record.reason;
        EXPECT_NE(record.outcome, Outcome::Crash) << planner << ": " << record.reason;
        solved += record.outcome == Outcome::Solved;
    }
    EXPECT_GE(solved, 13);
}

/// Inverse kinematics puts joints exactly at their limits, where a pole of the limits would be infinite.
TEST(SpatialPlanners, HppmMayEndAtALimit)
{
    Scenario scenario = tinySpatialScenario();
    auto &goal = std::get<Eigen::VectorXd>(scenario.spatial().task.goal);
    goal[1] = 1.5;
    const Record record = runOnce(specOf(scenario, "hppm"));
    EXPECT_EQ(record.outcome, Outcome::Solved) << record.reason;
}
}  // namespace
}  // namespace narrows
