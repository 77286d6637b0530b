// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChainCertificate.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "LeaderScenes.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

const ChordObstacles<2> nothing({});

constexpr double near = 5.02;  ///< to walls: what touches cannot be certified

/// Straight up the outer wall of the corner, then along the other one: what lets the longest links through.
PointPath<2> outerWalls()
{
    return {{100.0, 50.0},          {near, 300.0},   {near, 1080.0 - near}, {near + 20.0, 1100.0 - near},
            {800.0, 1100.0 - near}, {1050.0, 1000.0}};
}

ChainFailure alongOuterWalls(double length)
{
    const LeaderScene<2> scene = cornerL();
    const LeaderPath<2> path(outerWalls(), scene.entrance);
    return certifyChain<2>(path, ChordObstacles<2>(scene.obstacles), {10, length, 5.0}).failure;
}

TEST(ChainCertificate, LongestLinkRoundARightAngle)
{
    // Both ends on the outer walls, w - r from the inner ones: sqrt2 (2 (w - r) - sqrt2 r) = 541.5.
    const double longest = std::sqrt(2.0) * (2.0 * 195.0 - std::sqrt(2.0) * 5.0);
    EXPECT_NEAR(longest, 541.5, 0.05);
    EXPECT_EQ(alongOuterWalls(longest - 0.1), ChainFailure::None);
    EXPECT_EQ(alongOuterWalls(540.0), ChainFailure::None);
    EXPECT_EQ(alongOuterWalls(longest + 0.1), ChainFailure::ChordClearance);
    EXPECT_EQ(alongOuterWalls(545.0), ChainFailure::ChordClearance);
}

TEST(ChainCertificate, NamesAJump)
{
    // A spike sideways, after which the last place so far away is suddenly before it.
    const PointPath<2> spike{{0.0, 0.0}, {10.0, 0.0}, {10.0, 4.0}, {10.1, 4.0}, {10.1, 0.0}, {30.0, 0.0}};
    const ChainCertificate refused = certifyChain<2>(LeaderPath<2>(spike, Vector2d::UnitX()), nothing, {20, 5.0, 0.1});
    EXPECT_EQ(refused.failure, ChainFailure::Jump);
    // g leaves the tip of the spike when the front end is 3 from its foot: s = 10 + 4 + 0.1 + 4 + 3.
    EXPECT_NEAR(refused.place, 21.1, 0.2);
    const PointPath<2> bump{{0.0, 0.0}, {10.0, 0.0}, {12.0, 1.0}, {14.0, 0.0}, {30.0, 0.0}};
    EXPECT_TRUE(certifyChain<2>(LeaderPath<2>(bump, Vector2d::UnitX()), nothing, {20, 5.0, 0.1}));
}

TEST(ChainCertificate, NamesJointsAndLinks)
{
    const LeaderPath<2> corner({{0.0, 0.0}, {9.0, 0.0}, {10.0, 1.0}, {10.0, 20.0}}, Vector2d::UnitX());
    EXPECT_EQ(certifyChain<2>(corner, nothing, {2, 5.0, 0.1}).failure, ChainFailure::TooShort);
    EXPECT_EQ(certifyChain<2>(corner, nothing, {10, 5.0, 0.1, 1.2}).failure, ChainFailure::JointLimit);
    const ChainCertificate wide = certifyChain<2>(corner, nothing, {10, 5.0, 0.1, 1.6});
    EXPECT_EQ(wide.failure, ChainFailure::None);
    EXPECT_GT(wide.largestAngle, 1.2);
    EXPECT_LT(wide.largestAngle, 0.5 * M_PI);

    // Round a square back to where it came from.
    const PointPath<3> loop{{0, 0, 0},   {19, 0, 0}, {20, 1, 0}, {20, 19, 0},
                            {19, 20, 0}, {6, 20, 0}, {5, 19, 0}, {5, -20, 0.5}};
    const ChordObstacles<3> empty({});
    const LeaderPath<3> path(loop, Vector3d::UnitX());
    EXPECT_EQ(certifyChain<3>(path, empty, {30, 4.0, 0.1, 2.0, true}).failure, ChainFailure::None);
    EXPECT_EQ(certifyChain<3>(path, empty, {30, 4.0, 0.2, 2.0, true}).failure, ChainFailure::SelfCollision);
    EXPECT_EQ(certifyChain<3>(path, empty, {30, 4.0, 0.2, 2.0, false}).failure, ChainFailure::None);
}

TEST(ChainCertificate, RefusesWhatIsNoChain)
{
    const LeaderPath<2> path({{0.0, 0.0}, {1.0, 0.0}}, Vector2d::UnitX());
    EXPECT_THROW(certifyChain<2>(path, nothing, {0, 1.0, 0.1}), std::invalid_argument);
    EXPECT_THROW(certifyChain<2>(path, nothing, {1, 0.0, 0.1}), std::invalid_argument);
    EXPECT_THROW(certifyChain<2>(path, nothing, {1, 1.0, -0.1}), std::invalid_argument);
}

/// What dense samples of the chords say: least clearance, greatest jump of the rear end per length of the front's way.
struct Sampled
{
    double clearance = std::numeric_limits<double>::infinity();
    double fastest = 0.0;
};

Sampled sample(const LeaderPath<2> &path, const ChordObstacles<2> &obstacles, double length)
{
    constexpr double step = 2e-3;
    Sampled result;
    double before = path.follower(0.0, length);
    for (double s = step; s <= path.length(); s += step)
    {
        const double place = path.follower(s, length);
        result.clearance = std::min(result.clearance, obstacles.clearance(path.at(place), path.at(s), 10.0));
        result.fastest = std::max(result.fastest, (path.at(place) - path.at(before)).norm() / step);
        before = place;
    }
    return result;
}

TEST(ChainCertificate, AgreesWithDenseSamplesOnRandomPaths)
{
    int accepted = 0, touches = 0;
    for (unsigned seed = 1; seed <= 120; ++seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> draw(-1.0, 1.0);
        PointPath<2> nodes{Vector2d::Zero()};
        for (int i = 0; i < 12; ++i)
            nodes.push_back(nodes.back() + Vector2d(1.0 + 0.4 * draw(random), 0.6 * draw(random)));
        std::vector<PlanarObstacle> discs;
        for (int i = 0; i < 4; ++i)
            discs.push_back({"disc" + std::to_string(i),
                             Circle{{6.0 + 5.0 * draw(random), (i % 2 ? 1.0 : -1.0) * (2.0 + draw(random))}, 0.8}});
        const LeaderPath<2> path(nodes, Vector2d::UnitX());
        const ChordObstacles<2> obstacles(discs);
        const ChainCertificate certificate = certifyChain<2>(path, obstacles, {20, 2.0, 0.1});
        const Sampled sampled = sample(path, obstacles, 2.0);
        switch (certificate.failure)
        {
            case ChainFailure::None:
                ++accepted;
                EXPECT_GE(sampled.clearance, 0.1) << seed;
                EXPECT_LT(sampled.fastest, 100.0) << seed;
                break;
            case ChainFailure::ChordClearance:
                ++touches;
                EXPECT_LT(sampled.clearance, 0.1 + 5e-3) << seed;
                break;
            case ChainFailure::Jump:
                EXPECT_GT(sampled.fastest, 10.0) << seed;
                break;
            default:
                ADD_FAILURE() << seed << ' ' << toText(certificate.failure);
        }
    }
    EXPECT_GE(accepted, 20);
    EXPECT_GE(touches, 20);
}
}  // namespace
}  // namespace narrows
