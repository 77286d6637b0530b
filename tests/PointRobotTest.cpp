// SPDX-License-Identifier: BSD-3-Clause
// Point robots in a plain RealVectorStateSpace among discs: what OMPL's 2denvs.cpp and PlannerTest.h check of a
// planner, in an environment of our own, for HPPM and viapoint. tests/ompl runs those files themselves, where they are
// at hand.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "kernel/ControlPoints.h"
#include "planners/HPPM.h"
#include "planners/ViaPointHomotopy.h"
#include "spaces/JointStateSpace.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double side = 60.0;

struct Disc
{
    Vector2d center;
    double radius;
};

/// Rows of discs that are set against each other: 30 of radius 3.5, gaps of 3 between neighbours, so that every long
/// straight motion is blocked.
std::vector<Disc> quincunx()
{
    std::vector<Disc> discs;
    for (int row = 0; row < 5; ++row)
        for (int k = 0; k < 6; ++k)
            discs.push_back({{5.0 + 10.0 * k + 5.0 * (row % 2), 10.0 + 10.0 * row}, 3.5});
    return discs;
}

double clearanceOf(const std::vector<Disc> &discs, const Vector2d &point)
{
    double least = side;
    for (const Disc &disc : discs)
        least = std::min(least, (point - disc.center).norm() - disc.radius);
    return least;
}

Vector2d pointOf(const ob::State *state)
{
    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return {values[0], values[1]};
}

std::shared_ptr<const RepulsionModel> modelOf(const std::vector<Disc> &discs)
{
    std::vector<DistanceFunction> obstacles;
    for (const Disc &disc : discs)
        obstacles.push_back({"disc" + std::to_string(obstacles.size()), [disc](const auto &point, VectorXd *gradient)
                             {
                                 const Vector2d apart = point - disc.center;
                                 if (gradient != nullptr)
                                     *gradient = apart.normalized();
                                 return apart.norm() - disc.radius;
                             }});
    return controlPointModel(pointRobot(2), obstacles, 2.0);
}

/// The least clearance of any point of a path, in closed form: of each of its segments to each disc.
double clearanceOf(const std::vector<Disc> &discs, const og::PathGeometric &path)
{
    double least = side;
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        for (const Disc &disc : discs)
        {
            const Vector2d from = pointOf(path.getState(i - 1)), way = pointOf(path.getState(i)) - from;
            const double t = way.squaredNorm() > 0.0 ? (disc.center - from).dot(way) / way.squaredNorm() : 0.0;
            const Vector2d nearest = from + std::min(std::max(t, 0.0), 1.0) * way;
            least = std::min(least, (nearest - disc.center).norm() - disc.radius);
        }
    return least;
}

class PointRobot : public testing::TestWithParam<std::string>
{
protected:
    PointRobot() : setup_(plane())
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // setSeed() says that it comes late
        ompl::RNG::setSeed(5);
        setup_.setStateValidityChecker(
            [this](const ob::State *state)
            {
                outside_ += setup_.getStateSpace()->satisfiesBounds(state) ? 0 : 1;
                return clearanceOf(discs_, pointOf(state)) > 0.0;
            });
        setup_.getSpaceInformation()->setStateValidityCheckingResolution(0.0005);
        ask({1.0, 1.0}, {58.0, 59.0});
        setup_.setPlanner(planner());
    }

    static ob::StateSpacePtr plane()
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, side);
        return space;
    }

    std::shared_ptr<ModelPlanner> planner()
    {
        const auto &si = setup_.getSpaceInformation();
        if (GetParam() == "hppm")
            return std::make_shared<HPPM>(si, modelOf(discs_));
        return std::make_shared<ViaPointHomotopy>(si, false);
    }

    void ask(const Vector2d &from, const Vector2d &to)
    {
        ob::ScopedState<> start(setup_.getStateSpace()), goal(setup_.getStateSpace());
        start[0] = from.x(), start[1] = from.y();
        goal[0] = to.x(), goal[1] = to.y();
        setup_.setStartAndGoalStates(start, goal, 1e-3);
    }

    ob::PlannerStatus solve() { return setup_.solve(ob::plannerNonTerminatingCondition()); }

    const std::vector<Disc> discs_ = quincunx();
    og::SimpleSetup setup_;
    int outside_ = 0;  ///< states outside the bounds that the checker was asked about
};

TEST_P(PointRobot, FindsWaysThatAreFreeInClosedForm)
{
    ompl::RNG random;
    for (int query = 0; query < 50; ++query)
    {
        Vector2d ends[2];
        for (Vector2d &end : ends)
            do
                end = {random.uniformReal(0.0, side), random.uniformReal(0.0, side)};
            while (clearanceOf(discs_, end) < 0.1);
        setup_.clear();
        ask(ends[0], ends[1]);
        ASSERT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION) << query;
        og::PathGeometric &path = setup_.getSolutionPath();
        EXPECT_EQ(pointOf(path.getState(0)), ends[0]);
        EXPECT_LE((pointOf(path.getStates().back()) - ends[1]).norm(), 1e-3);
        EXPECT_GT(clearanceOf(discs_, path), -1e-3);  // what OMPL's validator can miss between states 0.04 apart
    }
    EXPECT_EQ(outside_, 0);
}

TEST_P(PointRobot, SolvesAgainAfterClearAndGoesOnAfterBeingStopped)
{
    const ob::PlannerPtr planner = setup_.getPlanner();
    ASSERT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    setup_.clear();
    EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    setup_.clear();
    EXPECT_FALSE(planner->solve(ob::plannerAlwaysTerminatingCondition()));
    EXPECT_FALSE(setup_.haveSolutionPath());
    EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    planner->clear();
    planner->clear();
}

TEST_P(PointRobot, EndsWhereOnlyStartAndGoalAreValid)
{
    const ob::State *start = setup_.getProblemDefinition()->getStartState(0);
    const ob::State *goal = setup_.getGoal()->as<ob::GoalState>()->getState();
    const auto &space = setup_.getStateSpace();
    setup_.setStateValidityChecker([&](const ob::State *state)
                                   { return space->equalStates(state, start) || space->equalStates(state, goal); });
    int asked = 0;
    EXPECT_FALSE(setup_.solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 500; })));
    EXPECT_FALSE(setup_.haveSolutionPath());
}

TEST_P(PointRobot, TakesAValidStartAndAnyOfSeveralGoals)
{
    const Vector2d blocked = discs_[7].center, start(1.0, 1.0);
    const std::vector<Vector2d> ends{blocked, {58.0, 59.0}, {1.0, 59.0}};
    const auto stateAt = [this](const Vector2d &point)
    {
        ob::ScopedState<> state(setup_.getStateSpace());
        state[0] = point.x(), state[1] = point.y();
        return state;
    };
    setup_.clearStartStates();
    setup_.addStartState(stateAt(blocked));
    setup_.addStartState(stateAt(start));
    const auto goals = std::make_shared<ob::GoalStates>(setup_.getSpaceInformation());
    for (const Vector2d &end : ends)
        goals->addState(stateAt(end));
    setup_.setGoal(goals);
    ASSERT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    og::PathGeometric &path = setup_.getSolutionPath();
    EXPECT_EQ(pointOf(path.getState(0)), start);
    const Vector2d end = pointOf(path.getStates().back());
    EXPECT_TRUE(end == ends[1] || end == ends[2]) << end.transpose();
}

TEST_P(PointRobot, DataMarkStartAndGoal)
{
    ASSERT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(setup_.getSpaceInformation());
    setup_.getPlannerData(data);
    EXPECT_GE(data.numEdges(), 2u);
    EXPECT_GE(data.numStartVertices(), 1u);
    EXPECT_GE(data.numGoalVertices(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Ours, PointRobot, testing::Values("hppm", "viapoint"),
                         [](const auto &planner) { return planner.param; });

TEST(JointsOf, ReadsAPlainSpaceAsItIs)
{
    const auto plain = std::make_shared<ob::RealVectorStateSpace>(2);
    plain->setBounds(-4.0, 9.0);
    const auto joints = jointsOf(plain);
    ASSERT_NE(joints, nullptr);
    ob::ScopedState<> state(plain);
    joints->fromConfiguration(Vector2d(7.5, -3.0), state.get());
    EXPECT_EQ(pointOf(state.get()), Vector2d(7.5, -3.0));  // nothing wraps
    VectorXd q;
    joints->toConfiguration(state.get(), q);
    EXPECT_EQ(q, VectorXd(Vector2d(7.5, -3.0)));
    EXPECT_EQ(joints->getBounds().high[1], 9.0);
    const auto own = std::make_shared<JointStateSpace>(std::vector<ArmJoint>{{true, std::nullopt, true}});
    EXPECT_EQ(jointsOf(own), own);
    EXPECT_EQ(jointsOf(std::make_shared<ob::RealVectorStateSpace>(0)), nullptr);
}
}  // namespace
}  // namespace narrows
