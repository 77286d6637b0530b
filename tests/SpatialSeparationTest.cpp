// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "validity/ConvexSets.h"
#include "validity/SupportDistance.h"

namespace narrows::proof
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double farAway = 100.0;

ConvexSet<3> only(const SpatialObstacle &obstacle)
{
    const Parts<3> parts = partsOf(std::vector<SpatialObstacle>{obstacle}, farAway);
    EXPECT_EQ(parts.all.size(), 1u);
    return parts.all.front().set;
}

ConvexSet<3> unitCube()
{
    return only({"cube", Box{Isometry3d(Eigen::Translation3d(0.5, 0.5, 0.5)), {0.5, 0.5, 0.5}}});
}

ConvexSet<3> can()
{
    return only({"can", Cylinder{{0, 0, 1}, {0, 0, 1}, 2.0, 1.0}});
}

/// Upright, over a right-angled triangle.
ConvexSet<3> wedge(double halfLength)
{
    return only({"wedge", Prism{{{0, 0}, {4, 0}, {0, 3}}, Isometry3d::Identity(), halfLength}});
}

ConvexSet<3> triangle()
{
    return only({"triangle", Mesh{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}, false}});
}

/// To full precision, from a direction that is of no help.
Separation<3> distanceOf(const ConvexSet<3> &set, const Segment<3> &segment)
{
    return separate<3>(set, segment, Vector3d(0.48, -0.64, 0.6), {});
}

void expectDistance(const ConvexSet<3> &set, const Segment<3> &segment, double expected)
{
    const Separation<3> found = distanceOf(set, segment);
    EXPECT_NEAR(found.lower, expected, 1e-12);
    EXPECT_NEAR(found.upper, expected, 1e-12);
    EXPECT_NEAR(found.direction.norm(), 1.0, 1e-12);
}

TEST(SpatialSeparation, OfAnyTwoFeaturesByHand)
{
    expectDistance(unitCube(), {{2, 2, 2}, {3, 4, 5}}, std::sqrt(3.0));       // corner against end
    expectDistance(unitCube(), {{0.5, 0.25, 1.25}, {0.5, 9, 9}}, 0.25);       // side against end
    expectDistance(unitCube(), {{-3, 0.5, 1.5}, {3, 0.5, 1.5}}, 0.5);         // side against all
    expectDistance(unitCube(), {{0, 2, 2}, {1, 2, 2}}, std::sqrt(2.0));       // edge against a parallel
    expectDistance(unitCube(), {{0.5, 3, 0}, {0.5, 0, 3}}, std::sqrt(0.5));   // edge against a crossing
    expectDistance(unitCube(), {{2, 2, -7}, {2, 2, 7}}, std::sqrt(2.0));      // edge against a parallel, longer
    expectDistance(triangle(), {{1, 1, 0.5}, {1, 1, 3}}, 0.5);                // inside against end
    expectDistance(triangle(), {{1, 1, 0.5}, {-1, 0.5, 0.5}}, 0.5);           // inside against all
    expectDistance(triangle(), {{-1, -1, 2}, {-1, -1, -2}}, std::sqrt(2.0));  // corner against the middle
    expectDistance(triangle(), {{2, 2, 2}, {2, 2, -2}}, std::sqrt(0.5));      // edge against the middle
    expectDistance(can(), {{0.3, 0.3, 2.25}, {0.3, 0.4, 9}}, 0.25);           // end against end
    expectDistance(can(), {{3, -5, 1}, {3, 5, 1}}, 1.0);                      // mantle against the middle
    expectDistance(can(), {{3, 4, 7}, {3, 4, -7}}, 3.0);                      // mantle against a parallel
    expectDistance(can(), {{6, 0, 5}, {7, 1, 6}}, 5.0);                       // rim against end
    expectDistance(can(), {{0, 0, 4}, {4, 0, 2}}, 4.0 / std::sqrt(20.0));     // rim against the middle
    for (const double half : {1.0, std::numeric_limits<double>::infinity()})
    {
        expectDistance(wedge(half), {{-3, -4, 0.5}, {-6, -9, 0.5}}, 5.0);  // edge against end
        expectDistance(wedge(half), {{5, 5.5, 0}, {9, 9, 0.5}}, 5.0);      // side against end
        expectDistance(wedge(half), {{-3, -4, -7}, {-3, -4, 7}}, 5.0);     // edge against a parallel
    }
    expectDistance(wedge(1.0), {{1, 1, 4}, {1, 1, 9}}, 3.0);                                          // top against end
    expectDistance(wedge(1.0), {{-1, -1, 2}, {-3, -3, 9}}, std::sqrt(3.0));                           // corner
    expectDistance(wedge(std::numeric_limits<double>::infinity()), {{5, 5.5, 50}, {9, 9, 60}}, 5.0);  // no end
    expectDistance(only({"ball", Sphere{{1, 2, 3}, 0.5}}), {{4, 0, 3}, {4, 9, 3}}, 3.0);  // of the core: a point
    expectDistance(only({"rod", Capsule{{0, 0, 0}, {1, 0, 0}, 0.5}}), {{0.5, 1, 2}, {0.5, 1, -2}}, 1.0);
    const Vector3d along = Vector3d(1, 2, 2) / 3.0, across = Vector3d(2, 1, -2) / 3.0;
    const Vector3d center = 40.0 * along;
    expectDistance(only({"endless", Cylinder{center, along, 0.5, std::numeric_limits<double>::infinity()}}),
                   {3.0 * across - 7.0 * along, 4.0 * across + 5.0 * along}, 3.0);
}

TEST(SpatialSeparation, HasNoSeparatingPlaneForSetsThatMeet)
{
    const Segment<3> through{{0.3, 0.4, -2}, {0.31, 0.42, 3}}, inside{{0.3, 0.4, 0.5}, {0.4, 0.6, 0.7}};
    for (const ConvexSet<3> &set : {unitCube(), can(), wedge(1.0), wedge(std::numeric_limits<double>::infinity())})
        for (const Segment<3> &segment : {through, inside})
        {
            const Separation<3> found = distanceOf(set, segment);
            EXPECT_LE(found.lower, 0.0);
            EXPECT_EQ(found.upper, 0.0);
        }
    EXPECT_LE(distanceOf(triangle(), through).upper, 1e-15);
    EXPECT_LE(distanceOf(triangle(), through).lower, 0.0);
}

TEST(SpatialSeparation, StaysSharpNextToContact)
{
    for (const double distance : {1e-7, 1e-10, 1e-12})
    {
        const double height = 1 + distance, beside = 0.5 * std::sqrt(2.0) * distance;
        for (const Segment<3> &segment :
             {Segment<3>{{-3, 0.4, height}, {5, 0.6, height}}, Segment<3>{{0.5, 0.4, height}, {2, 3, 7}},
              Segment<3>{{-2, 3 + beside, -1 + beside}, {2, -1 + beside, 3 + beside}}})
        {
            const Separation<3> found = distanceOf(unitCube(), segment);
            EXPECT_NEAR(found.lower, distance, 2e-15);
            EXPECT_NEAR(found.upper, distance, 2e-15);
        }
        EXPECT_LE(distanceOf(unitCube(), {{-3, 0.4, 1 - distance}, {5, 0.6, 1 - distance}}).lower, 0.0);
    }
}

/// A support function that comes out too small would let a link into the obstacle. Rounding errors are at their worst
/// where the direction is nearly along the axis.
TEST(SpatialSeparation, KnowsTheEndsOfCylinders)
{
    std::mt19937 generator(19);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto unit = [&]
    {
        return Vector3d(Vector3d::NullaryExpr([&] { return uniform(generator); }).normalized());
    };
    for (int trial = 0; trial < 4000; ++trial)
    {
        const Cylinder cylinder{unit(), unit(), 0.5, 0.4};
        const double angle = std::pow(10.0, -9.0 + 9.0 * uniform(generator));
        const Vector3d u =
            (Eigen::AngleAxisd(angle, cylinder.axis.unitOrthogonal()) * cylinder.axis * (trial % 2 == 0 ? 1 : -1))
                .normalized();
        const Vector3d point = supportPoint<3>({cylinder, 0.0, cylinder.center, 1.0}, u);
        const double greatest =
            cylinder.center.dot(u) + 0.4 * std::abs(cylinder.axis.dot(u)) + 0.5 * cylinder.axis.cross(u).norm();
        EXPECT_NEAR(point.dot(u), greatest, 1e-15) << "seed 19, trial " << trial << ", angle " << angle;
        EXPECT_LE(std::abs((point - cylinder.center).dot(cylinder.axis)), 0.4 + 1e-15);
        EXPECT_LE((point - cylinder.center).cross(cylinder.axis).norm(), 0.5 + 1e-15);
    }
}

/// The distance of two convex sets is the minimum over a grid on both, but for the grid's meshes, and never more.
TEST(SpatialSeparation, AgreesWithBruteForce)
{
    std::mt19937 generator(18);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto vector = [&](double size)
    {
        return Vector3d(Vector3d::NullaryExpr([&] { return size * uniform(generator); }));
    };
    constexpr int grid = 24;
    for (int trial = 0; trial < 300; ++trial)
    {
        const Segment<3> segment{vector(3.0), vector(3.0)};
        const Vector3d center = vector(1.0), size = Vector3d(0.2, 0.2, 0.2) + vector(1.0).cwiseAbs();
        const Isometry3d pose =
            Eigen::Translation3d(center) * Eigen::AngleAxisd(3.0 * uniform(generator), vector(1.0).normalized());
        const bool round = trial % 2 == 0;
        const ConvexSet<3> set = round ? only({"can", Cylinder{center, pose.linear().col(2), size.x(), size.z()}})
                                       : only({"box", Box{pose, size}});
        const Separation<3> found = distanceOf(set, segment);
        double least = 1e9;
        for (int i = 0; i <= grid; ++i)
            for (int j = 0; j <= grid; ++j)
                for (int k = 0; k <= grid; ++k)
                {
                    Vector3d local = Vector3d(i, j, k) * (2.0 / grid) - Vector3d::Ones();
                    if (round)
                        local.head<2>() = 0.5 * (local.x() + 1.0) *
                                          Eigen::Vector2d(std::cos(4.0 * local.y()), std::sin(4.0 * local.y()));
                    const Vector3d scale = round ? Vector3d(size.x(), size.x(), size.z()) : size;
                    const Vector3d point = pose * scale.cwiseProduct(local);
                    const Vector3d along = segment.to - segment.from;
                    const double t = std::clamp((point - segment.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
                    least = std::min(least, (segment.from + t * along - point).norm());
                }
        SCOPED_TRACE("seed 18, trial " + std::to_string(trial));
        EXPECT_LE(found.lower, found.upper + 1e-14);
        EXPECT_LE(found.lower, least + 1e-12);
        if (found.upper > 0.0)
        {
            EXPECT_NEAR(found.lower, found.upper, 1e-12);
            EXPECT_NEAR(found.upper, least, 0.2);  // half a mesh of the grid's surface
        }
    }
}

TEST(SpatialSeparation, KnowsWhatAMeshEncloses)
{
    // A tetrahedron with the corner of a cube, with all triangles turned outwards.
    Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, true};
    const Vector3d inside(0.2, 0.2, 0.2), outside(0.5, 0.5, 0.5), away(2, 2, 2);
    EXPECT_TRUE(encloses(SpatialObstacle{"mesh", mesh}, inside));
    EXPECT_FALSE(encloses(SpatialObstacle{"mesh", mesh}, outside));
    EXPECT_FALSE(encloses(SpatialObstacle{"mesh", mesh}, away));
    for (std::array<int, 3> &corners : mesh.triangles)
        std::swap(corners[0], corners[1]);
    EXPECT_TRUE(encloses(SpatialObstacle{"inside out", mesh}, inside));
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    EXPECT_THROW(partsOf(std::vector<SpatialObstacle>{{"one turned", mesh}}, farAway), std::invalid_argument);
    mesh.closed = false;
    EXPECT_FALSE(encloses(SpatialObstacle{"mesh", mesh}, inside));
    EXPECT_EQ(partsOf(std::vector<SpatialObstacle>{{"mesh", mesh}}, farAway).all.size(), 7u);
}
}  // namespace
}  // namespace narrows::proof
