// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SupportDistance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "validity/ConvexSets.h"

namespace narrows::proof
{
namespace
{
using Eigen::Vector2d;

const double pi = std::acos(-1.0);

ConvexSet<2> only(const PlanarObstacle &obstacle)
{
    const Parts<2> parts = partsOf({obstacle}, 0.0);
    EXPECT_EQ(parts.all.size(), 1u);
    return parts.all.front().set;
}

ConvexSet<2> unitSquare()
{
    return only({"square", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}});
}

/// To full precision, from a direction that is of no help.
Separation<2> distanceOf(const ConvexSet<2> &set, const Vector2d &a, const Vector2d &b)
{
    return separate<2>(set, {a, b}, Vector2d(0.6, -0.8), {});
}

void expectDistance(const ConvexSet<2> &set, const Vector2d &a, const Vector2d &b, double expected)
{
    const Separation<2> found = distanceOf(set, a, b);
    EXPECT_NEAR(found.lower, expected, 1e-12);
    EXPECT_NEAR(found.upper, expected, 1e-12);
    EXPECT_NEAR(found.direction.norm(), 1.0, 1e-12);
}

TEST(SupportDistance, OfHullsByHand)
{
    expectDistance(unitSquare(), {2, -5}, {2, 5}, 1.0);                         // side against side
    expectDistance(unitSquare(), {2, 2}, {3, 5}, std::sqrt(2.0));               // corner against end
    expectDistance(unitSquare(), {0, 3}, {3, 0}, std::sqrt(0.5));               // corner against the middle
    expectDistance(unitSquare(), {0.5, 1.25}, {0.5, 9}, 0.25);                  // side against end
    expectDistance(unitSquare(), {1.5, 0.5}, {9, 0.5}, 0.5);                    // the same, in line with the center
    expectDistance(only({"point", Circle{{1, 2}, 0.5}}), {4, 0}, {4, 9}, 3.0);  // of the core: a point
}

TEST(SupportDistance, OfASuperellipseByHand)
{
    const ConvexSet<2> shape = only({"E", Superellipse{{1, 1}, {2, 1}, 4.0}});
    expectDistance(shape, {4, 0}, {4, 3}, 1.0);
    expectDistance(shape, {-5, 2.25}, {5, 2.25}, 0.25);
    // The tangent with slope -a/b touches where both terms are 1/2.
    const Vector2d contact(1 + 2 * std::pow(0.5, 0.25), 1 + std::pow(0.5, 0.25));
    const Vector2d normal = Vector2d(0.5, 1.0).normalized();
    const Vector2d along(-normal.y(), normal.x());
    expectDistance(shape, contact + 0.3 * normal - along, contact + 0.3 * normal + 2 * along, 0.3);
}

TEST(SupportDistance, HasNoSeparatingLineForSetsThatMeet)
{
    for (const ConvexSet<2> &set : {unitSquare(), only({"E", Superellipse{{0.5, 0.5}, {0.5, 0.4}, 4.0}})})
    {
        for (const auto &[a, b] :
             {std::pair<Vector2d, Vector2d>{{-1, 0.5}, {2, 0.6}}, {{0.4, 0.4}, {0.6, 0.5}}, {{0.5, 0.5}, {0.5, 7}}})
        {
            const Separation<2> found = distanceOf(set, a, b);
            EXPECT_LE(found.lower, 0.0);
            EXPECT_EQ(found.upper, 0.0);
        }
    }
}

TEST(SupportDistance, StaysSharpNextToContact)
{
    const ConvexSet<2> square = unitSquare();
    for (const double distance : {1e-7, 1e-10, 1e-12})
    {
        const Separation<2> flat = distanceOf(square, {-3, 1 + distance}, {5, 1 + distance});
        EXPECT_NEAR(flat.lower, distance, 4e-16);
        const Separation<2> overlapping = distanceOf(square, {-3, 1 - distance}, {5, 1 - distance});
        EXPECT_LE(overlapping.lower, 0.0);
        EXPECT_LE(overlapping.upper, 0.0);
    }
}

TEST(SupportDistance, StopsAtTheGoal)
{
    SeparationGoal goal;
    goal.enough = 0.5;
    const Separation<2> enough = separate<2>(unitSquare(), {{3, 0.2}, {4, 9}}, Vector2d(0.8, 0.6), goal);
    EXPECT_GE(enough.lower, 0.5);
    EXPECT_LT(enough.lower, 1.99);  // the distance is 2, but nobody asked

    goal = {};
    goal.thickness = 4.0;
    EXPECT_LE(separate<2>(unitSquare(), {{3, 0.2}, {4, 9}}, Vector2d(0.0, 1.0), goal).upper, 4.0);
}

/// Bounds from both sides against a grid over the segment and the boundary.
TEST(SupportDistance, AgreesWithBruteForce)
{
    std::mt19937 generator(17);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    constexpr int turns = 400, steps = 60;
    for (int trial = 0; trial < 400; ++trial)
    {
        const double p = 2.0 + 6.0 * std::abs(uniform(generator));
        const Superellipse shape{{uniform(generator), uniform(generator)},
                                 {0.2 + std::abs(uniform(generator)), 0.2 + std::abs(uniform(generator))},
                                 p};
        const Vector2d a(3 * uniform(generator), 3 * uniform(generator)),
            b(3 * uniform(generator), 3 * uniform(generator));
        const Separation<2> found = distanceOf(only({"E", shape}), a, b);
        double least = 1e9;
        for (int i = 0; i < turns; ++i)
        {
            const double angle = 2 * pi * i / turns, c = std::cos(angle), s = std::sin(angle);
            const double scale = std::pow(std::pow(std::abs(c), p) + std::pow(std::abs(s), p), -1.0 / p);
            const Vector2d boundary = shape.center + scale * shape.halfExtents.cwiseProduct(Vector2d(c, s));
            for (int k = 0; k <= steps; ++k)
                least = std::min(least, (a + (b - a) * (1.0 * k / steps) - boundary).norm());
        }
        EXPECT_LE(found.lower, found.upper + 1e-14) << "seed 17, trial " << trial;
        EXPECT_LE(found.lower, least + 1e-12) << "seed 17, trial " << trial;
        if (found.upper > 0.0)
        {
            EXPECT_NEAR(found.lower, found.upper, 1e-12) << "seed 17, trial " << trial;
            EXPECT_NEAR(found.upper, least, 0.06) << "seed 17, trial " << trial;  // half the grid's widest mesh
        }
    }
}
}  // namespace
}  // namespace narrows::proof
