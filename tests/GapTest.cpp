// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/threading/Gap.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

PlanarObstacle box(double left, double bottom, double right, double top)
{
    return {"box", Polygon{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}}};
}

TEST(Gap, OfCirclesIsOnTheLineOfTheirCenters)
{
    const Vector2d one(0.3, -0.2), other(1.5, 1.4);  // 2 apart
    const auto gaps = findGaps({{"a", Circle{one, 0.8}}, {"b", Circle{other, 1.1999998}}}, 0.0, 0.1);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_NEAR(gaps[0].halfWidth, 1e-7, 1e-15);
    EXPECT_LT((gaps[0].axis - Vector2d(0.6, 0.8)).norm(), 1e-9);
    EXPECT_LT((gaps[0].middle - (one + 0.8000001 * Vector2d(0.6, 0.8))).norm(), 1e-9);
    EXPECT_NEAR(gaps[0].size, 0.8, 1e-9);
}

// By their thickness alone links would be led into such a channel when they are in it.
TEST(Gap, BetweenTheEndsOfPlatesIsAsLargeAsThese)
{
    const Gap gap = findGaps({box(0, 0, 0.1, 0.6), box(0, 0.6002, 0.1, 1.6)}, 0.0, 0.1).at(0);
    EXPECT_NEAR(gap.halfWidth, 1e-4, 1e-12);
    EXPECT_NEAR(gap.size, 0.3, 1e-9);
}

TEST(Gap, LinksRadiusNarrowsIt)
{
    const std::vector<PlanarObstacle> walls{box(0, 0, 1, 1), box(1.5, 0, 2, 1)};
    EXPECT_NEAR(findGaps(walls, 0.1, 1.0).at(0).halfWidth, 0.15, 1e-15);
    EXPECT_TRUE(findGaps(walls, 0.25, 1.0).empty());
    EXPECT_TRUE(findGaps(walls, 0.0, 0.25).empty());
}

TEST(Gap, OfParallelEdgesIsInTheMiddleOfWhatTheyShare)
{
    const Gap gap = findGaps({box(0, 0, 1, 1), box(1.2, 0.4, 2, 3)}, 0.0, 1.0).at(0);
    EXPECT_LT((gap.middle - Vector2d(1.1, 0.7)).norm(), 1e-9);
    EXPECT_LT((gap.axis - Vector2d(1, 0)).norm(), 1e-9);
    EXPECT_NEAR(gap.halfWidth, 0.1, 1e-12);
}

TEST(Gap, OfCornersIsBetweenThem)
{
    const Gap gap = findGaps({box(0, 0, 1, 1), box(1.3, 1.4, 2, 2)}, 0.0, 1.0).at(0);
    EXPECT_NEAR(gap.halfWidth, 0.25, 1e-12);
    EXPECT_LT((gap.middle - Vector2d(1.15, 1.2)).norm(), 1e-9);
    EXPECT_LT((gap.axis - Vector2d(0.6, 0.8)).norm(), 1e-9);
}

// A wall whose tip all but touches another: few directions separate them.
TEST(Gap, IsFoundWhereLongWallsNearlyTouch)
{
    const Gap gap = findGaps({box(0, 0, 10, 0.1), box(9.5, 0.100002, 9.6, 8)}, 0.0, 0.1).at(0);
    EXPECT_NEAR(gap.halfWidth, 1e-6, 1e-12);
    EXPECT_LT((gap.axis - Vector2d(0, 1)).norm(), 1e-6);
    EXPECT_NEAR(gap.middle.x(), 9.55, 1e-6);
}

TEST(Gap, ShapesThatMeetHaveNone)
{
    EXPECT_TRUE(findGaps({box(0, 0, 1, 1), box(0.5, 0.9, 2, 2)}, 0.0, 1.0).empty());
    EXPECT_TRUE(findGaps({{"a", Circle{{0, 0}, 1}}, {"b", Circle{{1.5, 0}, 0.6}}}, 0.0, 1.0).empty());
}

TEST(Gap, WithinOnePolygonIsFoundAndItsPartsHaveNone)
{
    // A U, 0.4 wide inside: its arms face each other, its triangles touch or overlap in what the shape fills.
    const PlanarObstacle u{"u",
                           Polygon{{{0, 0}, {1.4, 0}, {1.4, 2}, {0.9, 2}, {0.9, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}}}};
    const auto gaps = findGaps({u}, 0.0, 0.21);
    ASSERT_FALSE(gaps.empty());
    for (const Gap &gap : gaps)
    {
        EXPECT_NEAR(gap.halfWidth, 0.2, 1e-9);
        EXPECT_NEAR(gap.middle.x(), 0.7, 1e-9);
    }
}

/// Nearest points of two superellipses by brute force over their boundaries.
double sampledDistance(const Superellipse &one, const Superellipse &other)
{
    const auto boundary = [](const Superellipse &shape, double angle)
    {
        const Vector2d at(std::cos(angle), std::sin(angle));
        const double size = std::pow(std::abs(at.x() / shape.halfExtents.x()), shape.exponent) +
                            std::pow(std::abs(at.y() / shape.halfExtents.y()), shape.exponent);
        return Vector2d(shape.center + std::pow(size, -1.0 / shape.exponent) * at);
    };
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 1000; ++i)
        for (int j = 0; j < 1000; ++j)
            least = std::min(least, (boundary(one, i * M_PI / 500) - boundary(other, j * M_PI / 500)).norm());
    return least;
}

TEST(NearestPoints, OfSuperellipsesAgreeWithSampling)
{
    const std::vector<std::pair<Superellipse, Superellipse>> pairs{
        {{{0, 0}, {1, 0.5}, 4}, {{2, 1.5}, {0.7, 0.6}, 4}},
        {{{0, 0}, {2, 0.2}, 4}, {{1, 1}, {0.3, 0.5}, 2}},
        {{{0, 0}, {0.5, 1}, 6}, {{-1.5, 0.2}, {0.4, 0.8}, 3}}};
    for (const auto &[one, other] : pairs)
    {
        const NearestPoints nearest = nearestPoints(ConvexShape(one), ConvexShape(other));
        const double sampled = sampledDistance(one, other);
        EXPECT_LE(nearest.distance, sampled + 1e-12);
        EXPECT_GT(nearest.distance, sampled - 1e-4);
        EXPECT_NEAR((nearest.second - nearest.first).norm(), nearest.distance, 1e-7);
    }
}

TEST(NearestPoints, SupportIsFurthest)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-M_PI, M_PI);
    for (const double exponent : {2.0, 3.0, 4.0})
    {
        const Superellipse shape{{0.5, -1}, {1.5, 0.4}, exponent};
        const ConvexShape convex(shape);
        for (int i = 0; i < 200; ++i)
        {
            const double a = angle(random), b = angle(random);
            const Vector2d direction(std::cos(a), std::sin(a)), other(std::cos(b), std::sin(b));
            const Vector2d point = convex.support(direction),
                           size = (point - shape.center).cwiseQuotient(shape.halfExtents);
            EXPECT_NEAR(std::pow(std::abs(size.x()), exponent) + std::pow(std::abs(size.y()), exponent), 1.0, 1e-12);
            EXPECT_GE(direction.dot(point - convex.support(other)), -1e-12);
        }
    }
}

TEST(Gap, RefusesImpossibleWidths)
{
    EXPECT_THROW(findGaps({}, -1.0, 1.0), std::invalid_argument);
    EXPECT_THROW(findGaps({}, 0.0, 0.0), std::invalid_argument);
    EXPECT_TRUE(findGaps({}, 0.0, 1.0).empty());
}
}  // namespace
}  // namespace narrows
