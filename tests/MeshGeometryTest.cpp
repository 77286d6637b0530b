// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/MeshGeometry.h"

#include <gtest/gtest.h>

#include "Solids.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

TEST(MeshGeometry, MeshedBoxIsAsFarAwayAsTheBox)
{
    std::mt19937 generator(6);
    int outside = 0, through = 0, within = 0;
    for (int scene = 0; scene < 60; ++scene)
    {
        const Box box = randomBox(generator);
        const MeshGeometry mesh(boxMesh(box, 1 + scene % 4));
        int guess = 1000000;
        for (int trial = 0; trial < 50; ++trial)
        {
            const Vector3d a = randomPoint(trial % 2 == 0 ? 1.5 : 0.7, generator);
            const Vector3d b = trial % 2 == 0 ? randomPoint(1.5, generator) : Vector3d(a + randomPoint(0.1, generator));
            const Nearness solid = nearness(a, b, box);
            const Nearness near = mesh.nearest(a, b);
            if (std::abs(solid.distance) < 1e-12)
                continue;
            ASSERT_EQ(near.distance > 0.0, solid.distance > 0.0) << solid.distance;
            const Nearness guessed = mesh.nearest(a, b, &guess);
            ASSERT_EQ(guessed.distance, near.distance);
            ASSERT_EQ(guessed.point, near.point);
            const double room = 0.2 * trial / 50.0;
            ASSERT_EQ(mesh.keepsAway(a, b, room), solid.distance > room);
            if (solid.distance > 0.0)
            {
                ++outside;
                ASSERT_NEAR(near.distance, solid.distance, 1e-12);
                ASSERT_LT(
                    (near.foot() -
                     box.pose * (box.pose.inverse() * near.foot()).cwiseMax(-box.halfExtents).cwiseMin(box.halfExtents))
                        .norm(),
                    1e-12);
                continue;
            }
            const bool bothInside = std::max(PointDistance{a}(box), PointDistance{b}(box)) < 0.0;
            ++(bothInside ? within : through);
            ASSERT_EQ(mesh.contains(a), PointDistance{a}(box) < 0.0);
        }
    }
    EXPECT_GT(outside, 300);
    EXPECT_GT(through, 300);
    EXPECT_GT(within, 100);
}

TEST(MeshGeometry, ContainsAlsoStraightBelowAndAboveEdgesAndVertices)
{
    const Box box{Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}};
    const MeshGeometry mesh(boxMesh(box, 4));
    for (const double x : {-1.5, -0.5, 0.0, 0.25, 0.5, 1.5})
        for (const double y : {-1.5, -0.5, 0.0, 0.25, 0.5, 1.5})
            for (const double z : {-1.5, -0.75, 0.3, 1.5})
                EXPECT_EQ(mesh.contains({x, y, z}), std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1)
                    << x << " " << y << " " << z;
}

TEST(MeshGeometry, NegativeDistanceFadesAtContact)
{
    const Box box{Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}};
    const MeshGeometry mesh(boxMesh(box, 3));
    const Vector3d away(0.3, 0.2, 3.0);
    for (const double gap : {1e-2, 1e-5, 1e-9})
    {
        EXPECT_NEAR(mesh.nearest(away, {0.3, 0.2, 1.0 + gap}).distance, gap, 1e-12);
        EXPECT_NEAR(mesh.nearest(away, {0.3, 0.2, 1.0 - gap}).distance, -gap, 1e-12);
        EXPECT_NEAR(mesh.nearest({0.3, 0.2, 0.5}, {0.3, 0.2, 1.0 - gap}).distance, -gap, 1e-12);
    }
}

TEST(MeshGeometry, NothingSlipsThroughSharedEdgesAndVertices)
{
    const Box box{Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}};
    const MeshGeometry mesh(boxMesh(box, 4));
    std::mt19937 generator(2);
    std::uniform_int_distribution<int> step(-3, 3);
    for (int trial = 0; trial < 2000; ++trial)
    {
        const Vector3d crossing(0.25 * step(generator), 0.25 * step(generator), 1.0);
        const Vector3d direction = randomPoint(1.0, generator) + Vector3d(0.0, 0.0, 1.5);
        EXPECT_FALSE(mesh.keepsAway(crossing - 0.1 * direction, crossing + 0.1 * direction, 0.0));
        EXPECT_FALSE(mesh.keepsAway(crossing, crossing + 0.1 * direction, 0.0));
    }
}

TEST(MeshGeometry, OpenMeshesHaveNoInside)
{
    Mesh mesh = boxMesh({Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}}, 2);
    mesh.triangles.pop_back();
    EXPECT_THROW(MeshGeometry{mesh}, std::invalid_argument);
    mesh.closed = false;
    const MeshGeometry open(mesh);
    EXPECT_FALSE(open.contains(Vector3d::Zero()));
    EXPECT_NEAR(open.nearest({-0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}).distance, 0.9, 1e-12);
}

TEST(MeshGeometry, RefusesWhatIsNoMesh)
{
    const Mesh sound = boxMesh({Eigen::Isometry3d::Identity(), {1.0, 1.0, 1.0}}, 1);
    Mesh flipped = sound;
    std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
    EXPECT_THROW(MeshGeometry{flipped}, std::invalid_argument);
    Mesh missing = sound;
    missing.triangles[0][0] = 8;
    EXPECT_THROW(MeshGeometry{missing}, std::invalid_argument);
    EXPECT_THROW(MeshGeometry({{}, {}, false}), std::invalid_argument);
    Mesh infinite = sound;
    infinite.vertices[0].x() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(MeshGeometry{infinite}, std::invalid_argument);
}
}  // namespace
}  // namespace narrows
