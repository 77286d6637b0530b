// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "SpatialScenes.h"
#include "kernel/threading/FacingPatch.h"
#include "kernel/threading/SpatialShape.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double far = 3.0;

/// How far a shape reaches in a direction, from its definition.
struct Reach
{
    Vector3d direction;

    double operator()(const Sphere &sphere) const { return sphere.center.dot(direction) + sphere.radius; }
    double operator()(const Capsule &capsule) const
    {
        return std::max(capsule.from.dot(direction), capsule.to.dot(direction)) + capsule.radius;
    }
    double operator()(const Cylinder &cylinder) const
    {
        return cylinder.center.dot(direction) +
               std::min(cylinder.halfLength, far) * std::abs(cylinder.axis.dot(direction)) +
               cylinder.radius * cylinder.axis.cross(direction).norm();
    }
    double operator()(const Box &box) const
    {
        return box.pose.translation().dot(direction) +
               box.halfExtents.dot((box.pose.linear().transpose() * direction).cwiseAbs());
    }
    double operator()(const Prism &prism) const
    {
        const Vector3d local = prism.pose.linear().transpose() * direction;
        double most = -std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d &vertex : prism.vertices)
            most = std::max(most, vertex.dot(local.head<2>()));
        return prism.pose.translation().dot(direction) + most + std::min(prism.halfLength, far) * std::abs(local.z());
    }
};

SpatialShape::Convex randomConvex(int kind, std::mt19937 &generator)
{
    return std::visit(
        [](const auto &shape) -> SpatialShape::Convex
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
                throw std::logic_error("not convex");
            else
                return shape;
        },
        randomObstacle(kind, generator).shape);
}

void shift(SpatialShape::Convex &shape, const Vector3d &way)
{
    std::visit(ShiftBy{way}, shape);
}

// Two points and a plane between them prove a distance: the points are in the shapes and so far apart, and the shapes
// lie on both sides of a slab of that thickness.
TEST(SpatialShape, NearestPointsOfAllKindsAreProvenByASlab)
{
    std::mt19937 generator(5);
    int proven = 0;
    for (const int kind : {0, 1, 2, 3, 4, 6, 7})
        for (const int other : {0, 1, 2, 3, 4, 6, 7})
            for (int i = 0; i < 40; ++i)
            {
                const SpatialShape::Convex one = randomConvex(kind, generator);
                SpatialShape::Convex two = randomConvex(other, generator);
                shift(two, 1.5 * randomPoint(1.0, generator).normalized());
                const SpatialNearestPoints near = nearestPoints(SpatialShape(one, far), SpatialShape(two, far));
                if (!(near.distance > 1e-3))
                    continue;
                ++proven;
                const double slab = -std::visit(Reach{-near.direction}, two) - std::visit(Reach{near.direction}, one);
                EXPECT_NEAR(slab, near.distance, 1e-7) << "kinds " << kind << " " << other << " draw " << i;
                EXPECT_LT((near.second - near.first - near.distance * near.direction).norm(), 1e-9);
                EXPECT_LT(std::visit(PointDistance{near.first}, one), 1e-9);
                EXPECT_LT(std::visit(PointDistance{near.second}, two), 1e-9);
            }
    EXPECT_GT(proven, 300);
}

TEST(SpatialShape, FacesWithCornersEdgesAndFaces)
{
    const SpatialShape box(Box{Eigen::Isometry3d::Identity(), {1.0, 2.0, 3.0}}, far);
    EXPECT_EQ(box.facing(Vector3d::UnitZ(), 1e-9).size(), 4u);
    EXPECT_EQ(box.facing(Vector3d(0.6, 0.8, 0.0), 1e-9).size(), 2u);
    EXPECT_EQ(box.facing(Vector3d(1.0, 1.0, 1.0).normalized(), 1e-9), std::vector<Vector3d>{Vector3d(1.0, 2.0, 3.0)});
    EXPECT_EQ(box.leastHalfBreadth(), 1.0);
    const SpatialShape cylinder(Cylinder{Vector3d::Zero(), Vector3d::UnitX(), 0.5, 2.0}, far);
    EXPECT_EQ(cylinder.facing(Vector3d::UnitX(), 1e-9).size(), 4u);
    EXPECT_EQ(cylinder.facing(Vector3d::UnitY(), 1e-9).size(), 2u);
    EXPECT_EQ(cylinder.facing(Vector3d(0.6, 0.8, 0.0), 1e-9).size(), 1u);
    EXPECT_LT((cylinder.facing(Vector3d(0.6, 0.8, 0.0), 1e-9)[0] - Vector3d(2.0, 0.5, 0.0)).norm(), 1e-12);
    // A 3-4-5 triangle is least broad across its hypotenuse: 0.8 * 0.6 / 1.
    const SpatialShape prism(Prism{{{0.0, 0.0}, {0.8, 0.0}, {0.0, 0.6}}, Eigen::Isometry3d::Identity(), 5.0}, far);
    EXPECT_NEAR(prism.leastHalfBreadth(), 0.24, 1e-12);
}

TEST(SpatialShape, EndlessShapesEndWhereNobodyGets)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    const SpatialShape pipe(Cylinder{{0.0, 0.0, 1.0}, Vector3d::UnitX(), 0.5, endless}, far);
    EXPECT_EQ(pipe.edges().at(0).first, Vector3d(-far, 0.0, 1.0));
    EXPECT_TRUE(pipe.contains({2.9, 0.0, 1.4}));
    EXPECT_FALSE(pipe.contains({3.1, 0.0, 1.4}));
}

TEST(FacingPatch, IsTheCommonRectangle)
{
    const Vector3d axis = Vector3d::UnitZ();
    // [-1, 1] x [-3, 3] below, [0, 4] x [-1, 9] above: [0, 1] x [-1, 3] in common.
    const FacingPatch patch = facingPatch({{-1, -3, 0}, {1, -3, 0}, {1, 3, 0}, {-1, 3, 0}},
                                          {{0, -1, 1}, {4, -1, 1}, {4, 9, 1}, {0, 9, 1}}, axis, {9, 9, 9});
    EXPECT_LT((patch.middle - Vector3d(0.5, 1.0, 0.0)).norm(), 1e-12);
    EXPECT_LT(patch.along.cross(Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_NEAR(patch.halfLength, 2.0, 1e-12);
    EXPECT_NEAR(patch.halfBreadth, 0.5, 1e-12);
}

TEST(FacingPatch, OfParallelEdgesIsALine)
{
    const FacingPatch patch =
        facingPatch({{0, -3, 0}, {0, 3, 0}}, {{0, 1, 1}, {0, 5, 1}}, Vector3d::UnitZ(), {0, 0, 0.5});
    EXPECT_LT((patch.middle - Vector3d(0.0, 2.0, 0.0)).norm(), 1e-12);
    EXPECT_NEAR(patch.halfLength, 1.0, 1e-12);
    EXPECT_EQ(patch.halfBreadth, 0.0);
}

TEST(FacingPatch, OfCrossingEdgesIsAPoint)
{
    const Vector3d middle(0.0, 0.0, 0.5);
    const FacingPatch crossing =
        facingPatch({{0, -3, 0}, {0, 3, 0}}, {{-1, 0, 1}, {5, 0, 1}}, Vector3d::UnitZ(), middle);
    EXPECT_EQ(crossing.middle, middle);
    EXPECT_EQ(crossing.halfLength, 0.0);
    const FacingPatch corner = facingPatch({{0, 0, 0}}, {{-1, 0, 1}, {5, 0, 1}}, Vector3d::UnitZ(), middle);
    EXPECT_EQ(corner.middle, middle);
    EXPECT_EQ(corner.halfLength, 0.0);
}
}  // namespace
}  // namespace narrows
