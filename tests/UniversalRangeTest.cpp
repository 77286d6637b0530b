// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <boost/math/constants/constants.hpp>

#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();
constexpr unsigned int seed = 32;
constexpr double most = 0.7417649320975901;  // 42.5 degrees

double bend(double a, double b)
{
    return std::acos(std::cos(a) * std::cos(b));
}

UniversalRange cone(const std::optional<Interval> &first = std::nullopt,
                    const std::optional<Interval> &second = std::nullopt)
{
    return UniversalRange({0, 1, most}, first, second);
}

bool contains(const UniversalRange &range, double a, double b)
{
    const double joints[2] = {a, b};
    return range.contains(joints);
}

Eigen::Vector2d enforced(const UniversalRange &range, double a, double b)
{
    Eigen::Vector2d joints(a, b);
    range.enforce(joints.data());
    return joints;
}

class UniversalRangeTest : public testing::Test
{
protected:
    UniversalRangeTest()
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(seed);
    }
};

TEST_F(UniversalRangeTest, HoldsWhatBendsAtMostSoFar)
{
    ompl::RNG random;
    for (int i = 0; i < 10000; ++i)
    {
        const double a = random.uniformReal(-1.5, 1.5);
        const double b = random.uniformReal(-1.5, 1.5);
        if (std::abs(bend(a, b) - most) > 1e-9)
        {
            EXPECT_EQ(contains(cone(), a, b), bend(a, b) < most) << a << " " << b;
        }
    }
    EXPECT_TRUE(contains(cone(), most, 0.0));
    EXPECT_FALSE(contains(cone(), most + 1e-9, 0.0));
    EXPECT_FALSE(contains(cone(), 2.0 * pi, 0.0)) << "a joint that has been wound up";
    EXPECT_FALSE(contains(cone(), pi, pi)) << "acos(cos pi cos pi) is 0, the way there is not";
}

TEST_F(UniversalRangeTest, ResolvesSmallCones)
{
    const UniversalRange narrow({0, 1, 1e-6}, std::nullopt, std::nullopt);
    EXPECT_TRUE(contains(narrow, 0.6e-6, 0.799e-6));
    EXPECT_FALSE(contains(narrow, 0.6e-6, 0.801e-6));
}

TEST_F(UniversalRangeTest, MovesWhatIsOutsideToItsBorder)
{
    ompl::RNG random;
    for (int i = 0; i < 10000; ++i)
    {
        const double a = random.uniformReal(-4.0, 4.0);
        const double b = random.uniformReal(-4.0, 4.0);
        const Eigen::Vector2d inside = enforced(cone(), a, b);
        ASSERT_TRUE(contains(cone(), inside[0], inside[1])) << a << " " << b;
        EXPECT_EQ(enforced(cone(), inside[0], inside[1]), inside);
        if (contains(cone(), a, b))
            EXPECT_EQ(inside, Eigen::Vector2d(a, b));
        else
            EXPECT_NEAR(bend(inside[0], inside[1]), most, 1e-12) << a << " " << b;
    }
}

TEST_F(UniversalRangeTest, KeepsTheJointsOwnLimitsToo)
{
    const UniversalRange range = cone(Interval{0.2, 0.5}, Interval{-3.0, -0.3});
    EXPECT_EQ(range.second().lower, -most);
    ompl::RNG random;
    for (int i = 0; i < 10000; ++i)
    {
        const Eigen::Vector2d inside = enforced(range, random.uniformReal(-4.0, 4.0), random.uniformReal(-4.0, 4.0));
        ASSERT_TRUE(contains(range, inside[0], inside[1]));
        EXPECT_GE(inside[0], 0.2);
        EXPECT_LE(inside[0], 0.5);
        EXPECT_LE(inside[1], -0.3);
        EXPECT_LE(bend(inside[0], inside[1]), most + 1e-12);
    }
}

TEST_F(UniversalRangeTest, RefusesLimitsThatLeaveNothing)
{
    EXPECT_NO_THROW(cone(Interval{0.7, 0.8}));
    EXPECT_THROW(cone(Interval{0.8, 0.9}), std::invalid_argument);
    EXPECT_THROW(cone(Interval{0.6, 0.7}, Interval{-0.7, -0.6}), std::invalid_argument);
}

SpatialArm chain()
{
    return universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.0, std::nullopt, most);
}

TEST_F(UniversalRangeTest, SamplesAreUniformInTheCone)
{
    const auto space = std::make_shared<SpatialArmStateSpace>(chain(), FreeJoints::Wrapping);
    const ob::StateSamplerPtr sampler = space->allocStateSampler();
    ob::ScopedState<> state(space);
    // Over a cell of angles (a, b) the expected share is its share of the cone's area, found on a grid.
    constexpr int samples = 40000;
    constexpr int grid = 2000;
    int inner = 0;
    int corner = 0;
    long cells = 0;
    long innerCells = 0;
    long cornerCells = 0;
    const auto isInner = [](double a, double b)
    {
        return bend(a, b) < 0.5 * most;
    };
    const auto isCorner = [](double a, double b)
    {
        return a > 0.4 && b > 0.3;
    };
    for (int i = 0; i < samples; ++i)
    {
        sampler->sampleUniform(state.get());
        inner += isInner(state[2], state[3]);
        corner += isCorner(state[2], state[3]);
    }
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j)
        {
            const double a = most * (2.0 * (i + 0.5) / grid - 1.0);
            const double b = most * (2.0 * (j + 0.5) / grid - 1.0);
            const bool within = bend(a, b) <= most;
            cells += within;
            innerCells += isInner(a, b);
            cornerCells += within && isCorner(a, b);
        }
    const auto expectShare = [&](int count, long part)
    {
        const double share = static_cast<double>(part) / static_cast<double>(cells);
        const double deviation = std::sqrt(samples * share * (1.0 - share));
        EXPECT_NEAR(count, samples * share, 5.0 * deviation);
    };
    expectShare(inner, innerCells);
    expectShare(corner, cornerCells);
}

TEST_F(UniversalRangeTest, StraightMotionsBetweenStatesAtTheLimitStayWithin)
{
    const auto space = std::make_shared<SpatialArmStateSpace>(chain(), FreeJoints::Wrapping);
    ompl::RNG random;
    ob::ScopedState<> a(space);
    ob::ScopedState<> b(space);
    ob::ScopedState<> between(space);
    for (int i = 0; i < 2000; ++i)
    {
        for (unsigned int joint = 0; joint < space->getDimension(); ++joint)
        {
            a[joint] = random.uniformReal(-3.0, 3.0);
            b[joint] = random.uniformReal(-3.0, 3.0);
        }
        space->enforceBounds(a.get());
        space->enforceBounds(b.get());
        for (double t = 0.0; t <= 1.0; t += 0.0625)
        {
            space->interpolate(a.get(), b.get(), t, between.get());
            ASSERT_TRUE(space->satisfiesBounds(between.get())) << "case " << i << " t " << t;
        }
    }
}

TEST_F(UniversalRangeTest, JointsBelongToOneUniversalJointOnly)
{
    std::vector<SpatialJoint> joints = chain().joints();
    EXPECT_THROW(
        SpatialArmStateSpace(SpatialArm(joints, chain().links(), {{0, 1, most}, {1, 2, most}}), FreeJoints::Wrapping),
        std::invalid_argument);
}
}  // namespace
}  // namespace narrows
