// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SuperellipseGeometry.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// The boundary as a dense polygon: a second, slower way to the same distances.
Polygon outline(const Superellipse &shape, int count)
{
    Polygon polygon;
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2.0 * std::acos(-1.0) * i / count;
        const double c = std::cos(angle), s = std::sin(angle);
        const double power = 2.0 / shape.exponent;
        polygon.vertices.push_back(shape.center +
                                   Vector2d(shape.halfExtents.x() * std::copysign(std::pow(std::abs(c), power), c),
                                            shape.halfExtents.y() * std::copysign(std::pow(std::abs(s), power), s)));
    }
    return polygon;
}

class SuperellipseOfExponent : public testing::TestWithParam<double>
{
protected:
    const Superellipse shape{{0.5, -0.25}, {1.968, 0.473}, GetParam()};
    const SuperellipseGeometry geometry{shape};
};

TEST_P(SuperellipseOfExponent, DistancesAgreeWithADenseOutline)
{
    const Polygon polygon = outline(shape, 4000);
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-4.0, 4.0);
    int apart = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const Vector2d a(uniform(generator), uniform(generator));
        const Vector2d b = trial % 10 == 0 ? a : Vector2d(uniform(generator), uniform(generator));
        const double expected = distance(a, b, polygon);
        const double measured = geometry.distance(a, b);
        // The outline lies inside the shape, by less than 1e-3 where it is sparse.
        EXPECT_NEAR(measured, expected, 1e-3) << "trial " << trial << ": " << a.transpose() << " to " << b.transpose();
        EXPECT_LE(measured, expected + 1e-9) << "trial " << trial;
        if (expected > 2e-3)
        {
            ++apart;
            EXPECT_TRUE(geometry.farther(a, b, 0.0)) << "trial " << trial;
            EXPECT_TRUE(geometry.farther(a, b, 0.999 * measured)) << "trial " << trial;
            EXPECT_FALSE(geometry.farther(a, b, 1.001 * measured)) << "trial " << trial;
        }
        else if (expected == 0.0)
        {
            EXPECT_FALSE(geometry.farther(a, b, 0.0)) << "trial " << trial;
        }
    }
    EXPECT_GT(apart, 1000);
}

TEST_P(SuperellipseOfExponent, SeparationsShowALineBetween)
{
    std::mt19937 generator(8);
    std::uniform_real_distribution<double> uniform(-3.0, 3.0);
    int apart = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const Vector2d a(uniform(generator), uniform(generator));
        const Vector2d b(uniform(generator), uniform(generator));
        const double exact = geometry.distance(a, b);
        const auto found = geometry.separate(a, b, 0.0, std::numeric_limits<double>::infinity());
        if (exact == 0.0)
        {
            EXPECT_EQ(found.lower, 0.0) << "trial " << trial;
            continue;
        }
        ++apart;
        EXPECT_LE(found.lower, exact + 1e-11) << "trial " << trial;
        EXPECT_GE(found.upper, exact - 1e-11) << "trial " << trial;
        EXPECT_LE(found.upper - found.lower, found.lower / 32.0 + 1e-11) << "trial " << trial;
        const Vector2d &end = geometry.distance(a, a) < geometry.distance(b, b) ? a : b;
        const double between = found.direction.dot(end - geometry.center()) - geometry.support(found.direction);
        EXPECT_GE(between, found.lower - 1e-11) << "trial " << trial;
        EXPECT_NEAR(found.direction.norm(), 1.0, 1e-12);
        EXPECT_GT(geometry.separate(a, b, 0.0, 0.5 * exact).lower, 0.5 * exact) << "trial " << trial;
    }
    EXPECT_GT(apart, 900);
}

TEST_P(SuperellipseOfExponent, SlopeIsTheDerivativeOfValue)
{
    const Vector2d point(1.3, 0.4), direction(0.6, -0.8);
    const double h = 1e-6;
    const double difference =
        (geometry.value(point + h * direction) - geometry.value(point - h * direction)) / (2.0 * h);
    EXPECT_NEAR(geometry.slope(point, direction), difference, 1e-6 * std::max(1.0, std::abs(difference)));
}

TEST_P(SuperellipseOfExponent, SupportIsTheLargestProjection)
{
    const Polygon polygon = outline(shape, 4000);
    for (const Vector2d &direction : {Vector2d(1, 0), Vector2d(0, -1), Vector2d(-0.3, 2.0), Vector2d(1e-9, 1.0)})
    {
        double largest = 0.0;
        for (const Vector2d &vertex : polygon.vertices)
            largest = std::max(largest, direction.dot(vertex - shape.center));
        EXPECT_NEAR(geometry.support(direction), largest, 1e-4);
        EXPECT_GE(geometry.support(direction), largest - 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(Exponents, SuperellipseOfExponent, testing::Values(2.0, 2.5, 4.0, 8.0));

TEST(SuperellipseGeometry, ExponentTwoIsAnEllipseAndEqualExtentsACircle)
{
    const SuperellipseGeometry circle(Superellipse{{1.0, 2.0}, {0.7, 0.7}, 2.0});
    const Vector2d a(3.0, 1.0), b(2.0, 4.0);
    EXPECT_NEAR(circle.distance(a, b), std::sqrt(squaredDistance(a, b, {1.0, 2.0})) - 0.7, 1e-11);
}

TEST(SuperellipseGeometry, TouchingCountsAsMeeting)
{
    const SuperellipseGeometry shape(Superellipse{{0.0, 0.0}, {2.0, 1.0}, 4.0});
    EXPECT_FALSE(shape.farther({-3.0, 1.0}, {3.0, 1.0}, 0.0));
    EXPECT_FALSE(shape.farther({2.0, 0.0}, {5.0, 0.0}, 0.0));
    EXPECT_TRUE(shape.farther({-3.0, 1.0 + 1e-9}, {3.0, 1.0 + 1e-9}, 0.0));
    EXPECT_EQ(shape.distance({-0.1, 0.0}, {0.1, 0.0}), 0.0);  // wholly inside
}
}  // namespace
}  // namespace narrows
