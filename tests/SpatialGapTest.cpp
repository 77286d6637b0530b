// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "Solids.h"
#include "kernel/threading/SpatialGap.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double far = 10.0;

SpatialObstacle box(const Vector3d &lower, const Vector3d &upper)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = 0.5 * (lower + upper);
    return {"box", Box{pose, 0.5 * (upper - lower)}};
}

/// A wall, 0.1 thick about x = 1, in [-2, 2] x [-2, 2] of y and z, with an opening.
std::vector<SpatialObstacle> wallWith(double left, double right, double bottom, double top)
{
    return {box({0.95, -2, -2}, {1.05, 2, bottom}), box({0.95, -2, top}, {1.05, 2, 2}),
            box({0.95, -2, bottom}, {1.05, left, top}), box({0.95, right, bottom}, {1.05, 2, top})};
}

/// A torus about the x axis, corners on its innermost circle.
Mesh ring(double large, double small, int around, int across)
{
    Mesh mesh{{}, {}, true};
    const double turn = 2.0 * std::acos(-1.0);
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
        {
            const double a = turn * i / around, b = turn * j / across, r = large - small * std::cos(b);
            mesh.vertices.emplace_back(small * std::sin(b), r * std::cos(a), r * std::sin(a));
        }
    const auto vertex = [&](int i, int j)
    {
        return across * (i % around) + j % across;
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
        {
            mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)});
            mesh.triangles.push_back({vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    return mesh;
}

TEST(SpatialGap, OfBallsIsAPoint)
{
    const auto gaps = findGaps({{"a", Sphere{{0, 0, 0}, 0.5}}, {"b", Sphere{{0, 0.6, 0.8}, 0.499998}}}, 0.0, 0.1, far);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_NEAR(gaps[0].halfDistance, 1e-6, 1e-14);
    EXPECT_LT((gaps[0].axis - Vector3d(0, 0.6, 0.8)).norm(), 1e-12);
    EXPECT_LT((gaps[0].middle - 0.500001 * Vector3d(0, 0.6, 0.8)).norm(), 1e-12);
    EXPECT_EQ(gaps[0].along, Vector3d::Zero().eval());
    EXPECT_EQ(gaps[0].size, 0.499998);
}

TEST(SpatialGap, ASlotHasALineAlongIt)
{
    const auto gaps =
        findGaps({box({0.95, -1, -2}, {1.05, 3, 0.0}), box({0.95, -2, 0.1}, {1.05, 2, 2})}, 0.02, 0.1, far);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_LT((gaps[0].middle - Vector3d(1.0, 0.5, 0.05)).norm(), 1e-12);
    EXPECT_LT((gaps[0].axis - Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_LT(gaps[0].along.cross(Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_NEAR(gaps[0].halfLength, 1.5, 1e-12);
    EXPECT_NEAR(gaps[0].halfDistance, 0.05, 1e-12);
    EXPECT_NEAR(gaps[0].size, 0.05, 1e-12);
}

TEST(SpatialGap, WidthsAndRadiiDecideWhatIsOne)
{
    const std::vector<SpatialObstacle> slot{box({0.95, -1, -2}, {1.05, 3, 0.0}), box({0.95, -2, 0.1}, {1.05, 2, 2})};
    EXPECT_EQ(findGaps(slot, 0.02, 0.0301, far).size(), 1u);
    EXPECT_TRUE(findGaps(slot, 0.02, 0.03, far).empty());
    EXPECT_TRUE(findGaps(slot, 0.05, 1.0, far).empty());  // links just do not fit
    EXPECT_THROW(findGaps(slot, -1e-9, 1.0, far), std::invalid_argument);
    EXPECT_THROW(findGaps(slot, 0.0, 0.0, far), std::invalid_argument);
    EXPECT_THROW(findGaps(slot, 0.0, 1.0, 0.0), std::invalid_argument);
}

// A hole out of the middle of its wall: the walls above and below it share far more than the hole.
TEST(SpatialGap, AHoleIsAGapForEveryPairOfSides)
{
    const auto gaps = findGaps(wallWith(0.7, 1.1, -0.6, -0.5), 0.02, 0.3, far);
    ASSERT_EQ(gaps.size(), 2u);
    for (const SpatialGap &gap : gaps)
        EXPECT_LT((gap.middle - Vector3d(1.0, 0.9, -0.55)).norm(), 1e-9);
    EXPECT_LT((gaps[0].axis - Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(gaps[0].halfDistance, 0.05, 1e-12);
    EXPECT_NEAR(gaps[0].halfLength, 0.2, 1e-9);
    EXPECT_LT((gaps[1].axis - Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_NEAR(gaps[1].halfDistance, 0.2, 1e-12);
    EXPECT_EQ(gaps[1].halfLength, 0.0);  // as long as it is thick
}

TEST(SpatialGap, ABoltAcrossASlotMakesTwo)
{
    std::vector<SpatialObstacle> slot{box({0.95, -1, -2}, {1.05, 1, 0.0}), box({0.95, -1, 0.1}, {1.05, 1, 2})};
    slot.push_back({"bolt", Cylinder{{1.0, 0.4, 0.05}, Vector3d::UnitZ(), 0.1, 0.2}});
    const auto gaps = findGaps(slot, 0.02, 0.1, far);
    ASSERT_EQ(gaps.size(), 2u);
    EXPECT_LT((gaps[0].middle - Vector3d(1.0, -0.35, 0.05)).norm(), 1e-9);
    EXPECT_NEAR(gaps[0].halfLength, 0.65, 1e-9);
    EXPECT_LT((gaps[1].middle - Vector3d(1.0, 0.75, 0.05)).norm(), 1e-9);
    EXPECT_NEAR(gaps[1].halfLength, 0.25, 1e-9);
}

TEST(SpatialGap, WhatIsFilledIsNone)
{
    const std::vector<SpatialObstacle> balls{{"a", Sphere{{0, 0, 0}, 0.5}}, {"b", Sphere{{0, 1.1, 0}, 0.5}}};
    EXPECT_EQ(findGaps(balls, 0.0, 0.1, far).size(), 1u);
    std::vector<SpatialObstacle> filled = balls;
    filled.push_back(box({-1, 0.5, -1}, {1, 0.6, 1}));
    EXPECT_TRUE(findGaps(filled, 0.01, 0.1, far).empty());
}

TEST(SpatialGap, AMeshRingLooksAtItself)
{
    const auto gaps = findGaps({{"ring", ring(0.4, 0.1, 16, 8)}}, 0.05, 0.3, far);
    ASSERT_EQ(gaps.size(), 4u);  // 16 corners, directions less than 30 degrees apart count as one
    for (const SpatialGap &gap : gaps)
    {
        EXPECT_LT(gap.middle.norm(), 1e-9);
        EXPECT_LT(std::abs(gap.axis.x()), 1e-9);
        EXPECT_NEAR(gap.halfDistance, 0.3, 1e-9);
    }
    EXPECT_TRUE(findGaps({{"ring", ring(0.4, 0.1, 16, 8)}}, 0.05, 0.24, far).empty());
}

TEST(SpatialGap, AMeshLooksAtOthers)
{
    const Box below{Eigen::Isometry3d::Identity(), {1, 1, 0.5}};
    Box above = below;
    above.pose.translation().z() = 1.1;
    for (const SpatialObstacle &other : {SpatialObstacle{"mesh", boxMesh(above, 2)}, SpatialObstacle{"box", above}})
    {
        const auto gaps = findGaps({{"below", boxMesh(below, 3)}, other}, 0.0, 0.1, far);
        ASSERT_FALSE(gaps.empty()) << other.name;
        for (const SpatialGap &gap : gaps)
        {
            EXPECT_NEAR(gap.halfDistance, 0.05, 1e-9);
            EXPECT_NEAR(gap.middle.z(), 0.55, 1e-9);
            EXPECT_NEAR(std::abs(gap.axis.z()), 1.0, 1e-9);
        }
    }
}
}  // namespace
}  // namespace narrows
