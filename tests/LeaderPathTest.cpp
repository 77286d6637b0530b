// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LeaderPath.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// A right angle: 10 along x, then 10 along y.
LeaderPath<2> corner()
{
    return {{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}}, Vector2d::UnitX()};
}

template <int D>
LeaderPath<D> randomPath(unsigned seed, double wild)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> draw(-1.0, 1.0);
    PointPath<D> nodes{Eigen::Matrix<double, D, 1>::Zero()};
    for (int i = 0; i < 40; ++i)
    {
        Eigen::Matrix<double, D, 1> step = Eigen::Matrix<double, D, 1>::UnitX();
        for (double &x : step)
            x += wild * draw(random);
        nodes.push_back(nodes.back() + step);
    }
    return {nodes, Eigen::Matrix<double, D, 1>::UnitX()};
}

TEST(LeaderPath, RoundACornerJointsFollowPythagoras)
{
    const LeaderPath<2> path = corner();
    EXPECT_DOUBLE_EQ(path.length(), 20.0);
    // The front is 3 up, so that the rear is sqrt(5^2 - 3^2) = 4 before the corner.
    EXPECT_NEAR(path.follower(13.0, 5.0), 6.0, 1e-12);
    EXPECT_NEAR(path.follower(10.0, 5.0), 5.0, 1e-12);
    EXPECT_NEAR(path.follower(18.0, 5.0), 13.0, 1e-12);
}

TEST(LeaderPath, EntranceLineHasNoEnd)
{
    const LeaderPath<2> path = corner();
    EXPECT_NEAR(path.follower(2.0, 5.0), -3.0, 1e-12);
    EXPECT_NEAR(path.follower(-7.0, 5.0), -12.0, 1e-12);
    EXPECT_TRUE(path.at(-3.0).isApprox(Vector2d(-3.0, 0.0)));
    const std::vector<double> places = jointPlaces<2>(path, 13.0, 5.0, 3);
    ASSERT_EQ(places.size(), 4U);
    EXPECT_NEAR(places[2], 1.0, 1e-12);
    EXPECT_NEAR(places[3], -4.0, 1e-12);
}

/// Against a walk backwards in small steps.
template <int D>
void compareWithWalk(unsigned seed)
{
    const LeaderPath<D> path = randomPath<D>(seed, 1.5);
    constexpr double step = 1e-3;
    for (double s = 0.7; s < path.length(); s += 2.3)
    {
        const double found = path.follower(s, 2.5);
        EXPECT_NEAR((path.at(s) - path.at(found)).norm(), 2.5, 1e-9) << seed << ' ' << s;
        double walked = s;
        while ((path.at(s) - path.at(walked)).norm() < 2.5)
            walked -= step;
        EXPECT_GE(found, walked - 1e-9) << seed << ' ' << s;
        // Between two steps of the walk the path may have touched the circle; no further back, though.
        if (found > walked + step)
        {
            EXPECT_NEAR((path.at(s) - path.at(found + 0.5 * step)).norm(), 2.5, step);
        }
    }
}

TEST(LeaderPath, FollowerIsTheLastPlaceSoFarAway)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        compareWithWalk<2>(seed);
        compareWithWalk<3>(seed);
    }
}

TEST(LeaderPath, RefusesPathsWithoutLength)
{
    EXPECT_THROW(LeaderPath<2>({{1.0, 1.0}, {1.0, 1.0}}, Vector2d::UnitX()), std::invalid_argument);
    EXPECT_THROW(LeaderPath<2>({{0.0, 0.0}, {1.0, NAN}}, Vector2d::UnitX()), std::invalid_argument);
    EXPECT_THROW(LeaderPath<2>({{0.0, 0.0}, {1.0, 0.0}}, Vector2d::Zero()), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
