// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarArm.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
const double pi = std::acos(-1.0);

/// Base on a slide, two links, two fingers on the second one.
PlanarArm gripper()
{
    return PlanarArm({1.0, 0.0}, {{2.0, -1}, {1.0, 0}, {0.5, 1}, {0.5, 1}}, 0.1,
                     Slide{Eigen::Vector2d(0.0, 1.0), -1.0, 1.0});
}

TEST(PlanarArm, PlacesChainsAndBranchesFromAbsoluteAngles)
{
    Eigen::VectorXd q(5);
    q << 0.5, 0.0, pi / 2, 0.0, pi;
    std::vector<Eigen::Vector2d> points;
    gripper().place(q, points);
    ASSERT_EQ(points.size(), 5u);
    EXPECT_TRUE(points[0].isApprox(Eigen::Vector2d(1.0, 0.5)));
    EXPECT_TRUE(points[1].isApprox(Eigen::Vector2d(3.0, 0.5)));
    EXPECT_TRUE(points[2].isApprox(Eigen::Vector2d(3.0, 1.5)));
    EXPECT_TRUE(points[3].isApprox(Eigen::Vector2d(3.5, 1.5)));
    EXPECT_TRUE(points[4].isApprox(Eigen::Vector2d(2.5, 1.5)));
}

TEST(PlanarArm, ConvertsBetweenConventionsAlongTheTree)
{
    Eigen::VectorXd absolute(5);
    absolute << 0.5, 0.3, 1.0, 1.5, 0.2;
    const Eigen::VectorXd relative = gripper().fromAbsolute(absolute, AngleConvention::Relative);
    Eigen::VectorXd expected(5);
    expected << 0.5, 0.3, 0.7, 0.5, -0.8;  // both fingers against link 1
    EXPECT_TRUE(relative.isApprox(expected)) << relative.transpose();
    EXPECT_TRUE(gripper().toAbsolute(relative, AngleConvention::Relative).isApprox(absolute));
    EXPECT_EQ(gripper().toAbsolute(absolute, AngleConvention::Absolute), absolute);
}

TEST(PlanarArm, MotionBoundsAreNeverExceeded)
{
    const PlanarArm arm = gripper();
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Eigen::VectorXd q(5), delta(5), bounds, bends;
    std::vector<Eigen::Vector2d> speeds;
    std::vector<Eigen::Vector2d> from, to;
    for (int trial = 0; trial < 2000; ++trial)
    {
        for (int i = 0; i < 5; ++i)
        {
            q[i] = 3.0 * uniform(generator);
            delta[i] = uniform(generator);
        }
        arm.motionBounds(delta, bounds, bends);
        arm.place(q, from);
        arm.velocities(from, delta, speeds);
        arm.place(q + delta, to);
        for (int i = 0; i < arm.linkCount(); ++i)
        {
            const int base = arm.links()[i].parent + 1;
            EXPECT_LE((to[i + 1] - from[i + 1]).norm(), bounds[i] + 1e-12) << "trial " << trial;
            EXPECT_LE((to[base] - from[base]).norm(), bounds[i] + 1e-12) << "trial " << trial;
            // Taylor: what the velocity does not explain, the acceleration does.
            EXPECT_LE((to[i + 1] - from[i + 1] - speeds[i + 1]).norm(), 0.5 * bends[i] + 1e-12) << "trial " << trial;
        }
    }
}

TEST(PlanarArm, NeighboursMeetAtAJoint)
{
    const PlanarArm arm = gripper();
    EXPECT_TRUE(arm.areNeighbours(0, 1));
    EXPECT_TRUE(arm.areNeighbours(3, 1));
    EXPECT_TRUE(arm.areNeighbours(2, 3));  // the fingers
    EXPECT_FALSE(arm.areNeighbours(0, 2));
    EXPECT_FALSE(arm.areNeighbours(3, 0));
    EXPECT_TRUE(PlanarArm({0, 0}, {{1.0, -1}, {1.0, -1}}).areNeighbours(0, 1));  // both on the base
}

TEST(PlanarArm, ReachIsTheLongestChain)
{
    EXPECT_DOUBLE_EQ(gripper().reach(), 3.5);
}

TEST(PlanarArm, RefusesImpossibleArms)
{
    EXPECT_THROW(PlanarArm({0, 0}, {}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{0.0, -1}}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{std::nan(""), -1}}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{1.0, 0}}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{1.0, -2}}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{1.0, -1}}, -0.1), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{1.0, -1}}, 0.0, Slide{{2.0, 0.0}, 0.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(PlanarArm({0, 0}, {{1.0, -1}}, 0.0, Slide{{1.0, 0.0}, 1.0, 0.0}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
