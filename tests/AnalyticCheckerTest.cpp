// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "validity/ArmChecker.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// Is a point in an obstacle? From the definitions, nothing shared with the checkers.
bool inside(const PlanarObstacle &obstacle, const Vector2d &p)
{
    if (const auto *circle = std::get_if<Circle>(&obstacle.shape))
        return (p - circle->center).norm() <= circle->radius;
    const auto &shape = std::get<Superellipse>(obstacle.shape);
    const Vector2d scaled = (p - shape.center).cwiseQuotient(shape.halfExtents);
    return std::pow(std::abs(scaled.x()), shape.exponent) + std::pow(std::abs(scaled.y()), shape.exponent) <= 1.0;
}

bool sampledCollision(const PlanarModel &model, const Vector2d &a, const Vector2d &b, int points)
{
    for (int i = 0; i <= points; ++i)
        for (const PlanarObstacle &obstacle : model.obstacles)
            if (inside(obstacle, a + static_cast<double>(i) / points * (b - a)))
                return true;
    return false;
}

class AnalyticChecker : public testing::TestWithParam<int>
{
};

TEST_P(AnalyticChecker, AgreesWithBruteForceSamplingOfThePapersCases)
{
    const Scenario scenario = paperCase(GetParam());
    const PlanarModel &model = *scenario.planar().model;
    const auto checker = makeAnalyticChecker(model);
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> angle(-std::acos(-1.0), std::acos(-1.0));
    std::vector<Vector2d> points;
    Eigen::VectorXd q(model.arm.dimension());
    int disagreements = 0, collisions = 0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        for (double &value : q)
            value = angle(generator);
        model.arm.place(q, points);
        for (int i = 0; i < model.arm.linkCount(); ++i)
        {
            const Vector2d &a = points[model.arm.links()[i].parent + 1];
            const bool hit = sampledCollision(model, a, points[i + 1], 200);
            const bool clear = checker->clears({a, points[i + 1], model.arm.radius()});
            collisions += hit;
            ASSERT_FALSE(hit && clear) << "trial " << trial << ", link " << i;
            // Sampling misses contacts shallower than its spacing.
            if (!hit && !clear)
            {
                ++disagreements;
                EXPECT_LE(checker->clearance({a, points[i + 1], model.arm.radius()}), 1e-9);
            }
        }
    }
    EXPECT_GT(collisions, 10);
    EXPECT_LT(disagreements, collisions / 20 + 5);
}

TEST_P(AnalyticChecker, MarginAndClearanceSayTheSame)
{
    const Scenario scenario = paperCase(GetParam());
    const double radius = 0.02;
    const auto checker = makeAnalyticChecker(*scenario.planar().model);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(-2.0, 6.0);
    for (int trial = 0; trial < 3000; ++trial)
    {
        const Vector2d a(uniform(generator), uniform(generator));
        const Vector2d b = a + Vector2d(uniform(generator) - 2.0, uniform(generator) - 2.0) * 0.3;
        const double clearance = checker->clearance({a, b, radius});
        EXPECT_EQ(checker->clears({a, b, radius}), clearance > 0.0) << "trial " << trial;
        if (clearance > 0.0)
        {
            EXPECT_TRUE(checker->clears({a, b, radius + clearance * (1.0 - 1e-9)})) << "trial " << trial;
            EXPECT_FALSE(checker->clears({a, b, radius + clearance * (1.0 + 1e-9)})) << "trial " << trial;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, AnalyticChecker, testing::Values(1, 2, 3));

// The figures of docs/hppm.md, which tell the readings of the paper's ellipsoids apart.
TEST(PaperCases, StartsAndGoalsHaveTheMeasuredClearances)
{
    const double expected[3][2] = {{0.972, 0.0564}, {2.061, 0.0155}, {0.270, 0.1239}};
    for (int number = 1; number <= 3; ++number)
    {
        const PlanarWorld world = paperCase(number).planar();
        const auto checker = makeArmChecker("analytic", *world.model);
        EXPECT_NEAR(checker->clearance(world.task.start), expected[number - 1][0], 6e-4) << number;
        EXPECT_NEAR(checker->clearance(std::get<Eigen::VectorXd>(world.task.goal)), expected[number - 1][1], 6e-5)
            << number;
    }
}

TEST(PlanarChecker, KnowsPolygonsAndEmptyScenes)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}});
    const double radius = 0.125;  // exact in binary, so that touching is touching
    const auto square = makeAnalyticChecker({arm, {{"S", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}}});
    EXPECT_FALSE(square->clears({{-1.0, 0.5}, {2.0, 0.5}, radius}));
    EXPECT_FALSE(square->clears({{0.4, 0.5}, {0.6, 0.5}, radius}));
    EXPECT_FALSE(square->clears({{-1.0, 1.125}, {2.0, 1.125}, radius}));  // touches with its half-width
    EXPECT_TRUE(square->clears({{-1.0, 1.25}, {2.0, 1.25}, 0.245}));
    EXPECT_FALSE(square->clears({{-1.0, 1.25}, {2.0, 1.25}, 0.255}));
    EXPECT_NEAR(square->clearance({{-1.0, 1.25}, {2.0, 1.25}, radius}), 0.125, 1e-12);
    const auto nothing = makeAnalyticChecker({arm, {}});
    EXPECT_TRUE(nothing->clears({{0, 0}, {1, 0}, 1e6}));
    EXPECT_EQ(nothing->clearance({{0, 0}, {1, 0}, radius}), std::numeric_limits<double>::infinity());
}

TEST(PlanarChecker, UnknownNamesAreRefused)
{
    EXPECT_THROW(makeChecker("guess", *paperCase(1).planar().model), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
