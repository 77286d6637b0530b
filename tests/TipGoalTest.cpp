// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "SpatialRobots.h"
#include "kernel/TipJacobian.h"
#include "spaces/PullTip.h"
#include "spaces/TipGoalRegion.h"

namespace narrows
{
namespace
{
constexpr unsigned int seed = 33;

Eigen::Vector3d tipOf(const SpatialArm &arm, const Eigen::VectorXd &q, int link)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement.points[2 * link + 1];
}

void expectDifferences(const SpatialArm &arm, const Eigen::VectorXd &q)
{
    constexpr double step = 1e-5;
    SpatialArm::Placement placement;
    arm.place(q, placement);
    Eigen::Matrix3Xd jacobian;
    for (int link = 0; link < arm.linkCount(); ++link)
    {
        tipJacobian(arm, placement, link, jacobian);
        for (int joint = 0; joint < arm.dimension(); ++joint)
        {
            const Eigen::VectorXd move = step * Eigen::VectorXd::Unit(arm.dimension(), joint);
            const Eigen::Vector3d difference = (tipOf(arm, q + move, link) - tipOf(arm, q - move, link)) / (2.0 * step);
            EXPECT_LT((jacobian.col(joint) - difference).norm(), 1e-9) << "link " << link << " joint " << joint;
        }
    }
}

TEST(TipJacobian, IsTheDerivativeOfEveryLinksEnd)
{
    std::mt19937 generator(seed);
    for (const SpatialArm &arm : {snake(), sixAxisArm(), gantryHand()})
        for (int i = 0; i < 20; ++i)
            expectDifferences(arm, randomVector(arm.dimension(), 1.5, generator));
}

class TipGoalTest : public testing::Test
{
protected:
    TipGoalTest()
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(seed);
    }

    /// Pulls random states to where the tip of other random states is. \return how many got there
    template <typename Space, typename TipTarget>
    static int reached(const std::shared_ptr<Space> &space, TipTarget goal, int tries)
    {
        const ob::StateSamplerPtr sampler = space->allocStateSampler();
        ob::ScopedState<> state(space);
        int count = 0;
        for (int i = 0; i < tries; ++i)
        {
            sampler->sampleUniform(state.get());
            goal.point = space->tip(state.get(), goal.link);
            sampler->sampleUniform(state.get());
            const bool arrived = pullTip(*space, goal, state.get());
            EXPECT_TRUE(space->satisfiesBounds(state.get()));
            EXPECT_EQ(arrived, (space->tip(state.get(), goal.link) - goal.point).norm() <= 0.1 * goal.tolerance);
            count += arrived;
        }
        return count;
    }
};

TEST_F(TipGoalTest, PullsMostStatesOntoThePointWithinTheLimits)
{
    const auto wrapping = FreeJoints::Wrapping;
    EXPECT_GT(reached(std::make_shared<SpatialArmStateSpace>(snake(), wrapping), SpatialTipGoal{3, {}, 1e-3}, 200),
              100);
    EXPECT_GT(reached(std::make_shared<SpatialArmStateSpace>(sixAxisArm(), wrapping), SpatialTipGoal{4, {}, 1e-3}, 200),
              100);
}

/// Pulls an arm on a slide that is written in some unit of length. \return slide (in that unit) and angles
Eigen::Vector3d pulled(double unit)
{
    const PlanarArm arm({0.0, 0.0}, {{0.5 * unit, -1}, {0.4 * unit, 0}}, 0.0,
                        Slide{{1.0, 0.0}, -1.0 * unit, 1.0 * unit});
    const auto space =
        std::make_shared<PlanarArmStateSpace>(arm, AngleConvention::Relative, FreeJoints::Wrapping, JointLimits{});
    ob::ScopedState<> state(space);
    space->fromConfiguration(Eigen::Vector3d(-0.5 * unit, 0.3, 0.9), state.get());
    EXPECT_TRUE(pullTip(*space, {1, {1.2 * unit, 0.3 * unit}, 1e-3 * unit}, state.get()));
    return {state[0] / unit, state[1], state[2]};
}

TEST_F(TipGoalTest, MovesSlidesAndAnglesWhateverTheUnitOfLength)
{
    const Eigen::Vector3d inMetres = pulled(1.0);
    EXPECT_LT((pulled(1000.0) - inMetres).norm(), 1e-9);
    EXPECT_GT(inMetres[0], 0.0);
    EXPECT_GT(std::abs(inMetres[1] - 0.3), 0.1);
}

TEST_F(TipGoalTest, GivesOutFreeStatesOnly)
{
    const auto space = std::make_shared<SpatialArmStateSpace>(snake(), FreeJoints::Wrapping);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    const auto leansLeft = [](const ob::State *state)
    {
        return state->as<ob::RealVectorStateSpace::StateType>()->values[2] > 0.0;
    };
    si->setStateValidityChecker(leansLeft);
    si->setup();
    Eigen::VectorXd q = Eigen::VectorXd::Constant(space->getDimension(), 0.1);
    const SpatialTipGoal goal{3, tipOf(space->arm(), q, 3), 1e-3};
    const SpatialTipGoalRegion region(si, goal);
    ob::ScopedState<> state(space);
    for (int i = 0; i < 20; ++i)
    {
        region.sampleGoal(state.get());
        EXPECT_TRUE(region.isSatisfied(state.get()));
        EXPECT_TRUE(leansLeft(state.get()));
        EXPECT_TRUE(space->satisfiesBounds(state.get()));
    }
}
}  // namespace
}  // namespace narrows
