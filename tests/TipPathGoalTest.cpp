// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/TipPathGoal.h"

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalState.h>

#include "TipPathScenes.h"

namespace narrows
{
namespace
{
class TipPathGoalTest : public testing::Test
{
protected:
    Scenario scenario_ = tinyTipPathScenario();
    Problem problem_ = seeded(scenario_);
    const SpatialTipPath &asked_ = std::get<SpatialTipPath>(scenario_.spatial().task.goal);
};

TEST_F(TipPathGoalTest, IsTheGoalOfAProblemWithATipPath)
{
    const auto *goal = dynamic_cast<const TipPathGoal *>(problem_.pdef->getGoal().get());
    ASSERT_NE(goal, nullptr);
    EXPECT_TRUE(problem_.context.tipPath);
    EXPECT_EQ(goal->path().points, asked_.points);
    EXPECT_EQ(goal->path().link, 2);
    EXPECT_EQ(goal->path().tolerance, 1e-3);
    EXPECT_TRUE(goal->hasType(ob::GOAL_SAMPLEABLE_REGION));
    EXPECT_FALSE(seeded(tinySpatialScenario()).context.tipPath);
}

TEST_F(TipPathGoalTest, IsSatisfiedAtTheLastPointAlone)
{
    const auto &goal = *problem_.pdef->getGoal()->as<TipPathGoal>();
    ob::ScopedState<> state(problem_.si);
    for (std::size_t i = 0; i < 3; ++i)
    {
        const SpatialTipGoalRegion point(problem_.si, tipGoalAt(asked_, i));
        point.sampleGoal(state.get());
        ASSERT_TRUE(point.isSatisfied(state.get()));
        EXPECT_EQ(goal.isSatisfied(state.get()), i == 2);
    }
}

TEST_F(TipPathGoalTest, SamplesFreeStatesAtTheLastPoint)
{
    const auto &goal = *problem_.pdef->getGoal()->as<TipPathGoal>();
    ob::ScopedState<> state(problem_.si);
    for (int i = 0; i < 20; ++i)
    {
        goal.sampleGoal(state.get());
        EXPECT_TRUE(goal.isSatisfied(state.get()));
        EXPECT_TRUE(problem_.si->isValid(state.get()));
    }
}

TEST_F(TipPathGoalTest, NeedsAPoint)
{
    EXPECT_THROW(TipPathGoal(problem_.si, {2, {}, 1e-3}), std::invalid_argument);
}

TEST_F(TipPathGoalTest, OfOtherGoalsIsAPathOfOnePointOrNone)
{
    EXPECT_EQ(tipPathOf(*problem_.pdef->getGoal())->points, asked_.points);
    const std::optional<SpatialTipPath> single =
        tipPathOf(SpatialTipGoalRegion(problem_.si, {1, {0.5, 0.25, 0.0}, 0.01}));
    ASSERT_TRUE(single);
    EXPECT_EQ(single->link, 1);
    ASSERT_EQ(single->points.size(), 1U);
    EXPECT_EQ(single->points[0], Eigen::Vector3d(0.5, 0.25, 0.0));
    EXPECT_EQ(single->tolerance, 0.01);
    EXPECT_FALSE(tipPathOf(ob::GoalState(problem_.si)));
}
}  // namespace
}  // namespace narrows
