// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialDistance.h"

#include <gtest/gtest.h>

#include "Solids.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Least signed distance over the segment: many points, then ever finer around the best of them.
template <class Shape>
double searched(const Vector3d &a, const Vector3d &b, const Shape &shape)
{
    double low = 0.0, high = 1.0, least = 0.0;
    for (int round = 0; round < 14; ++round)
    {
        const double width = (high - low) / 20.0;
        double best = low;
        least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 20; ++k)
        {
            const double t = low + k * width;
            const double here = PointDistance{a + t * (b - a)}(shape);
            if (here < least)
            {
                least = here;
                best = t;
            }
        }
        low = std::max(0.0, best - width);
        high = std::min(1.0, best + width);
    }
    return least;
}

struct Tally
{
    int outside = 0;
    int inside = 0;
};

/// One segment: the distance is the least one, is found where it is said to be, and changes by the normal.
template <class Shape>
void examine(const Vector3d &a, const Vector3d &b, const Shape &shape, Tally &tally)
{
    const Nearness near = nearness(a, b, shape);
    ASSERT_NEAR(near.distance, searched(a, b, shape), 1e-9);
    ASSERT_NEAR((near.point - (a + near.fraction * (b - a))).norm(), 0.0, 1e-14);
    ASSERT_NEAR(near.normal.norm(), 1.0, 1e-12);
    ASSERT_NEAR(PointDistance{near.point}(shape), near.distance, 1e-9);
    ASSERT_NEAR(PointDistance{near.foot()}(shape), 0.0, 1e-9);
    if (near.distance > 1e-3)
        for (int i = 0; i < 3; ++i)
        {
            const Vector3d step = 1e-6 * Vector3d::Unit(i);
            const double slope =
                (PointDistance{near.point + step}(shape)-PointDistance{near.point - step}(shape)) / 2e-6;
            ASSERT_NEAR(near.normal[i], slope, 2e-3);
        }
    ++(near.distance > 0.0 ? tally.outside : tally.inside);
}

template <class MakeShape>
Tally examineMany(const MakeShape &make)
{
    std::mt19937 generator(12);
    Tally tally;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const auto shape = make(generator);
        const Vector3d a = randomPoint(2.0, generator);
        const Vector3d b = trial % 10 == 0  ? a
                           : trial % 10 < 4 ? Vector3d(a + randomPoint(0.3, generator))
                                            : randomPoint(2.0, generator);
        examine(a, b, shape, tally);
        if (testing::Test::HasFatalFailure())
        {
            ADD_FAILURE() << "trial " << trial;
            break;
        }
    }
    return tally;
}

TEST(SpatialDistance, OfSpheres)
{
    const Tally tally = examineMany(
        [](std::mt19937 &generator) {
            return Sphere{randomPoint(1.0, generator), 0.1 + randomPoint(0.9, generator).norm()};
        });
    EXPECT_GT(tally.outside, 300);
    EXPECT_GT(tally.inside, 300);
}

TEST(SpatialDistance, OfCapsules)
{
    const Tally tally = examineMany(
        [](std::mt19937 &generator)
        {
            return Capsule{randomPoint(1.0, generator), randomPoint(1.0, generator),
                           0.05 + randomPoint(0.5, generator).norm()};
        });
    EXPECT_GT(tally.outside, 300);
    EXPECT_GT(tally.inside, 300);
}

TEST(SpatialDistance, OfCylinders)
{
    const Tally tally = examineMany([](std::mt19937 &generator) { return randomCylinder(false, generator); });
    EXPECT_GT(tally.outside, 300);
    EXPECT_GT(tally.inside, 300);
}

TEST(SpatialDistance, OfEndlessCylinders)
{
    const Tally tally = examineMany([](std::mt19937 &generator) { return randomCylinder(true, generator); });
    EXPECT_GT(tally.outside, 300);
    EXPECT_GT(tally.inside, 300);
}

TEST(SpatialDistance, OfBoxes)
{
    const Tally tally = examineMany(randomBox);
    EXPECT_GT(tally.outside, 300);
    EXPECT_GT(tally.inside, 300);
}

TEST(SpatialDistance, OfPrisms)
{
    const Tally tally = examineMany([](std::mt19937 &generator) { return randomPrism(false, generator); });
    EXPECT_GT(tally.outside, 200);
    EXPECT_GT(tally.inside, 200);
}

TEST(SpatialDistance, OfEndlessPrisms)
{
    const Tally tally = examineMany([](std::mt19937 &generator) { return randomPrism(true, generator); });
    EXPECT_GT(tally.outside, 200);
    EXPECT_GT(tally.inside, 200);
}

/// Whatever a box is, the prism over its face is.
TEST(SpatialDistance, OfBoxesThatArePrisms)
{
    std::mt19937 generator(13);
    for (int trial = 0; trial < 1000; ++trial)
    {
        const Box box = randomBox(generator);
        const double x = box.halfExtents.x(), y = box.halfExtents.y();
        const Prism prism{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, box.pose, box.halfExtents.z()};
        const Vector3d a = randomPoint(2.0, generator), b = randomPoint(2.0, generator);
        const Nearness one = nearness(a, b, box), other = nearness(a, b, prism);
        ASSERT_NEAR(one.distance, other.distance, 1e-12) << "trial " << trial;
        if (one.distance > 1e-3)
        {
            ASSERT_NEAR((one.foot() - other.foot()).norm(), 0.0, 1e-9) << "trial " << trial;
        }
    }
}

TEST(SpatialDistance, OfSegmentsThatLieParallelToWhatTheyPass)
{
    const Box box{Eigen::Isometry3d::Identity(), {1.0, 0.5, 0.25}};
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.0, 1.0), Vector3d(3.0, 0.0, 1.0), box).distance, 0.75);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 1.5, 1.25), Vector3d(3.0, 1.5, 1.25), box).distance, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.0, 0.0), Vector3d(3.0, 0.0, 0.0), box).distance, -0.25);
    const Cylinder cylinder{Vector3d::Zero(), Vector3d::UnitX(), 0.5, 1.0};
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.0, 1.0), Vector3d(3.0, 0.0, 1.0), cylinder).distance, 0.5);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(2.0, -3.0, 0.0), Vector3d(2.0, 3.0, 0.0), cylinder).distance, 1.0);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.0, 0.0), Vector3d(3.0, 0.0, 0.0), cylinder).distance, -0.5);
    Prism roof{{{-1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, Eigen::Isometry3d::Identity(), 0.5};
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, -2.0, 0.0), Vector3d(3.0, -2.0, 0.0), roof).distance, 2.0);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(0.0, 2.0, -3.0), Vector3d(0.0, 2.0, 3.0), roof).distance, 1.0);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(1.0, 2.0, 0.0), Vector3d(2.0, 1.0, 0.0), roof).distance, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.25, 2.5), Vector3d(3.0, 0.25, 2.5), roof).distance, 2.0);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(0.0, 0.25, -3.0), Vector3d(0.0, 0.25, 3.0), roof).distance, -0.25);
    roof.halfLength = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(nearness(Vector3d(0.0, 2.0, 1e6), Vector3d(0.0, 2.0, 2e6), roof).distance, 1.0);
    const Capsule capsule{{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.5};
    EXPECT_DOUBLE_EQ(nearness(Vector3d(-3.0, 0.0, 1.0), Vector3d(3.0, 0.0, 1.0), capsule).distance, 0.5);
    EXPECT_DOUBLE_EQ(nearness(Vector3d(2.0, 0.0, 0.0), Vector3d(3.0, 0.0, 0.0), capsule).distance, 0.5);
}

/// The worst place for closest points of lines: nearly parallel, at all scales.
TEST(SpatialDistance, OfNearlyParallelSegments)
{
    std::mt19937 generator(3);
    for (int trial = 0; trial < 3000; ++trial)
    {
        const double tilt = std::pow(10.0, -trial % 15);
        const Vector3d a = randomPoint(1.0, generator), b = randomPoint(1.0, generator);
        const Vector3d shift = randomPoint(0.5, generator);
        const Capsule capsule{a + shift + tilt * randomPoint(1.0, generator),
                              b + shift + tilt * randomPoint(1.0, generator), 0.01};
        ASSERT_NEAR(nearness(a, b, capsule).distance, searched(a, b, capsule), 1e-12) << "trial " << trial;
    }
}
}  // namespace
}  // namespace narrows
