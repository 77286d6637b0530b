// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TautString.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"
#include "kernel/scaling/ConvexSection.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Polygons = std::vector<std::vector<Vector2d>>;

/// Corners (1, -1), (3, -1), (3, 1), (1, 1).
Polygons square()
{
    return {{{1.0, -1.0}, {3.0, -1.0}, {3.0, 1.0}, {1.0, 1.0}}};
}

TEST(TautString, IsStraightWhereNothingIsInTheWay)
{
    TautString string(square(), Vector2d::Zero());
    string.moveTip({0.0, 3.0});
    EXPECT_TRUE(string.contacts().empty());
    EXPECT_DOUBLE_EQ(string.length(), 3.0);
}

TEST(TautString, WrapsTheCornersThatItSweeps)
{
    TautString string(square(), Vector2d::Zero());
    string.moveTip({2.0, 4.0});
    string.moveTip({4.0, 1.5});
    ASSERT_EQ(string.contacts().size(), 1U);  // (1, 1); from there (3, 1) lies below the way to the tip
    EXPECT_EQ(string.contacts()[0].point, Vector2d(1.0, 1.0));
    EXPECT_EQ(string.contacts()[0].side, -1);
    string.moveTip({4.0, -3.0});
    ASSERT_EQ(string.contacts().size(), 2U);
    EXPECT_EQ(string.contacts()[1].point, Vector2d(3.0, 1.0));
    EXPECT_DOUBLE_EQ(string.length(), std::sqrt(2.0) + 2.0 + std::sqrt(17.0));
    string.moveTip({0.0, -3.0});
    EXPECT_EQ(string.contacts().size(), 3U);  // and (3, -1)
}

TEST(TautString, KeepsItsSideUntilItIsTakenBack)
{
    TautString string(square(), Vector2d::Zero());
    string.moveTip({2.0, 3.0});
    string.moveTip({5.0, 3.0});
    string.moveTip({5.0, 0.0});
    EXPECT_DOUBLE_EQ(string.length(), std::sqrt(2.0) + 2.0 + std::sqrt(5.0));
    string.moveTip({5.0, 3.0});
    string.moveTip({2.0, 3.0});
    EXPECT_TRUE(string.contacts().empty());
    // The other way round.
    string.moveTip({0.0, 3.0});
    string.moveTip({0.0, -3.0});
    string.moveTip({5.0, -3.0});
    string.moveTip({5.0, 0.0});
    ASSERT_EQ(string.contacts().size(), 2U);
    EXPECT_EQ(string.contacts()[0].point, Vector2d(1.0, -1.0));
    EXPECT_EQ(string.contacts()[0].side, 1);
}

TEST(TautString, WindsAsOftenAsItsTipDoes)
{
    TautString string(square(), Vector2d::Zero());
    string.moveTip({0.0, -2.0});
    for (int turn = 0; turn < 3; ++turn)
        for (const Vector2d &point : {Vector2d(4.0, -2.0), Vector2d(4.0, 2.0), Vector2d(0.5, 2.0), Vector2d(0.5, -2.0)})
            string.moveTip(point);
    // Two whole turns around the perimeter of 8 besides the ways to it and from it, in the last turn.
    EXPECT_GT(string.length(), 16.0 + 2.0 * std::sqrt(2.0));
    EXPECT_GE(string.contacts().size(), 11U);
}

TEST(TautString, PointsAreAtTheirShareOfTheLength)
{
    TautString string(square(), Vector2d::Zero());
    string.moveTip({2.0, 3.0});
    string.moveTip({5.0, 3.0});
    string.moveTip({5.0, 1.0});
    string.moveTip({4.0, 1.0 - 1e-6});
    std::vector<Vector2d> points;
    const double whole = string.length();
    string.pointsAt({0.0, 0.5 * std::sqrt(2.0) / whole, (std::sqrt(2.0) + 1.0) / whole, 1.0}, string.tip(), points);
    EXPECT_LT((points[0] - Vector2d(0.0, 0.0)).norm(), 1e-12);
    EXPECT_LT((points[1] - Vector2d(0.5, 0.5)).norm(), 1e-12);
    EXPECT_LT((points[2] - Vector2d(2.0, 1.0)).norm(), 1e-12);
    EXPECT_LT((points[3] - Vector2d(4.0, 1.0 - 1e-6)).norm(), 1e-12);
}

/// Disjoint discs and polygons, none near the origin.
std::vector<ConvexSection> randomSections(std::mt19937 &generator)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<ConvexSection> sections;
    while (sections.size() < 5)
    {
        const Vector2d center(10.0 * uniform(generator), 10.0 * uniform(generator));
        const double radius = 1.0 + std::abs(uniform(generator));
        bool free = center.norm() > radius + 0.5;
        for (const ConvexSection &other : sections)
            free = free && other.distance(center) > radius + 0.2;
        if (!free)
            continue;
        std::vector<Vector2d> corners;
        for (int i = 0; i < 5; ++i)
            corners.push_back(center + radius * Vector2d(uniform(generator), uniform(generator)).normalized());
        if (sections.size() % 2 == 0)
            sections.emplace_back(std::vector<Vector2d>{center}, radius);
        else
            sections.emplace_back(convexHull(corners), 0.0);
    }
    return sections;
}

/// How deep a point is inside a convex polygon; negative outside.
double depth(const std::vector<Vector2d> &polygon, const Vector2d &point)
{
    double least = 1e300;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        least = std::min(least, cross(edge, point - polygon[i]) / edge.norm());
    }
    return least;
}

/// No segment enters a polygon and every contact bends to its side: the string is the shortest of its class.
void expectTaut(const TautString &string, const Polygons &polygons)
{
    std::vector<Vector2d> nodes{string.anchor()};
    for (const TautString::Contact &contact : string.contacts())
        nodes.push_back(contact.point);
    nodes.push_back(string.tip());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (const std::vector<Vector2d> &polygon : polygons)
            for (double t = 0.05; t < 1.0; t += 0.1)
                ASSERT_LE(depth(polygon, nodes[i] + t * (nodes[i + 1] - nodes[i])), 1e-7);
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        ASSERT_GE(string.contacts()[i - 1].side * cross(nodes[i] - nodes[i - 1], nodes[i + 1] - nodes[i]), -1e-6);
}

TEST(TautString, StaysTautAndComesBackOnRandomWays)
{
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        const std::vector<ConvexSection> sections = randomSections(generator);
        Polygons polygons;
        for (const ConvexSection &section : sections)
            polygons.push_back(section.dangerPolygon(0.0));
        TautString string(polygons, Vector2d::Zero());
        std::vector<Vector2d> way{Vector2d::Zero()};
        std::vector<double> lengths{0.0};
        for (int step = 0; step < 400; ++step)
        {
            const Vector2d to = way.back() + 2.0 * Vector2d(uniform(generator), uniform(generator));
            bool free = to.norm() < 14.0;
            for (const ConvexSection &section : sections)
                free = free && section.distance(way.back(), to) > 1e-6;
            if (!free)
                continue;
            way.push_back(to);
            string.moveTip(to);
            lengths.push_back(string.length());
            if (step % 10 == 0)
            {
                ASSERT_NO_FATAL_FAILURE(expectTaut(string, polygons));
            }
        }
        for (std::size_t i = way.size() - 1; i-- > 0;)
        {
            string.moveTip(way[i]);
            ASSERT_NEAR(string.length(), lengths[i], 1e-6) << i;
        }
        EXPECT_TRUE(string.contacts().empty());
    }
}
}  // namespace
}  // namespace narrows
