// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "PaperScenes.h"
#include "validity/CircumscribedPolygon.h"
#include "validity/ConvexPieces.h"
#include "validity/ConvexSets.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// FCL's queries decide distances to 2e-6, and clearance() returns the lower end of 1e-5 (FclChecker.cpp).
constexpr double decided = 2e-6;
constexpr double resolved = 2e-5;

PlanarModel scene(std::vector<PlanarObstacle> obstacles, double radius = 0.0)
{
    return {PlanarArm({0, 0}, {{1.0, -1}}, radius), std::move(obstacles)};
}

/// A square with a notch, open to the left.
Polygon notched()
{
    return {{{1, -1}, {2, -1}, {2, 1}, {1, 1}, {1, 0.2}, {1.5, 0.2}, {1.5, -0.2}, {1, -0.2}}};
}

void expectClearance(const PlanarModel &model, const Vector2d &a, const Vector2d &b, double expected,
                     double safety = 0.0)
{
    const auto checker = makeFclChecker(model);
    const double radius = model.arm.radius();
    const double clearance = checker->clearance({a, b, radius});
    EXPECT_LE(clearance, expected + 1e-12);
    EXPECT_GE(clearance, expected - resolved - safety);
    EXPECT_TRUE(checker->clears({a, b, radius + expected - decided - safety}));
    EXPECT_FALSE(checker->clears({a, b, radius + expected + 1e-12}));
}

TEST(FclChecker, MeasuresEveryShapeByHand)
{
    expectClearance(scene({{"C", Circle{{0, 0}, 1.0}}}), {2, -1}, {2, 1}, 1.0);
    expectClearance(scene({{"B", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}}), {1.5, 0.2}, {3, 0.8}, 0.5);
    expectClearance(scene({{"B", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}}), {2, 2}, {3, 5}, std::sqrt(2.0));
    expectClearance(scene({{"T", Polygon{{{0, 0}, {2, 0}, {1, 1}}}}}), {0, 1.3}, {2, 1.3}, 0.3);
    expectClearance(scene({{"T", Polygon{{{0, 0}, {2, 0}, {1, 1}}}}}), {2, 1}, {3, 1}, std::sqrt(0.5));
    expectClearance(scene({{"E", Superellipse{{0, 0}, {2, 1}, 4.0}}}), {3, -1}, {3, 1}, 1.0, 1e-3);
    expectClearance(scene({{"E", Superellipse{{0, 0}, {2, 1}, 2.0}}}), {-1, 1.5}, {1, 1.5}, 0.5, 1e-3);
}

TEST(FclChecker, LeavesTheNotchOfAPolygonOpen)
{
    const PlanarModel model = scene({{"N", notched()}});
    expectClearance(model, {0.1, 0.05}, {1.2, 0.05}, 0.15);
    expectClearance(model, {0.1, 0.0}, {1.4, 0.0}, 0.1);
    EXPECT_FALSE(makeFclChecker(model)->clears({{0.1, 0.0}, {1.6, 0.0}, 0.0}));
    EXPECT_FALSE(makeFclChecker(model)->clears({{1.7, 0.5}, {1.8, 0.5}, 0.0}));  // all inside
}

TEST(FclChecker, CountsTheLinkRadius)
{
    expectClearance(scene({{"C", Circle{{0, 0}, 1.0}}}, 0.25), {2, -1}, {2, 1}, 0.75);
    expectClearance(scene({{"B", Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}}, 0.25), {1.5, 0.2}, {3, 0.8}, 0.25);
}

TEST(FclChecker, TakesTouchingAndOverlapForCollisions)
{
    for (const PlanarObstacle &obstacle :
         {PlanarObstacle{"C", Circle{{0, 0}, 1.0}}, PlanarObstacle{"E", Superellipse{{0, 0}, {1, 1}, 4.0}},
          PlanarObstacle{"B", Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}},
          PlanarObstacle{"P", Polygon{{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}}}})
    {
        const auto checker = makeFclChecker(scene({obstacle}));
        for (const auto &[a, b] : {std::pair<Vector2d, Vector2d>{{1, -2}, {1, 2}},
                                   {{-2, 0}, {2, 0}},
                                   {{-2, 0.1}, {2, 0.3}},
                                   {{0, 0}, {0.1, 0}},
                                   {{1, 0}, {3, 0}},
                                   {{0, 0}, {5, 0.5}}})
        {
            EXPECT_FALSE(checker->clears({a, b, 0.0}))
                << obstacle.name << " " << a.transpose() << ", " << b.transpose();
            EXPECT_LE(checker->clearance({a, b, 0.0}), 0.0)
                << obstacle.name << " " << a.transpose() << ", " << b.transpose();
        }
    }
}

TEST(FclChecker, FindsEmptyScenesFree)
{
    const auto checker = makeFclChecker(scene({}));
    EXPECT_TRUE(checker->clears({{0, 0}, {1, 0}, 1e9}));
    EXPECT_EQ(checker->clearance({{0, 0}, {1, 0}, 0.0}), std::numeric_limits<double>::infinity());
}

/// Distance by the verifier's geometry, which shares no code with the checker.
double supportDistance(const PlanarModel &model, const Vector2d &a, const Vector2d &b)
{
    double least = std::numeric_limits<double>::infinity();
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (proof::encloses(obstacle, a))
            return 0.0;
    for (const proof::Part<2> &part : proof::partsOf(model.obstacles, 100.0).all)
    {
        const double apart = proof::separate<2>(part.set, proof::Segment<2>{a, b}, {1, 0}, {}).upper;
        if (!part.isBox())
            least = std::min(least, apart - part.set.inflation - model.arm.radius());
    }
    return least;
}

double leastExtent(const PlanarModel &model)
{
    double extent = 0.0;
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (const auto *shape = std::get_if<Superellipse>(&obstacle.shape))
            extent = std::max(extent, shape->halfExtents.minCoeff());
    return extent;
}

std::vector<PlanarModel> randomLinkScenes()
{
    std::vector<PlanarModel> models{paperScene(1).model, paperScene(2).model, paperScene(3).model};
    models.push_back(scene({{"N", notched()}, {"B", Polygon{{{-3, -1}, {-1, -1}, {-1, -0.9}, {-3, -0.9}}}}}, 0.05));
    models.push_back(scene({{"S", Polygon{{{0, 0}, {3, 1}, {2, 2}, {3, 4}, {0.5, 2.5}, {-2, 4}}}}}, 0.0));
    return models;
}

/// Coarse (every link along an axis or a diagonal) and generic positions; the former put solvers into degenerate cases.
TEST(FclChecker, AgreesWithTheVerifierOn20000RandomLinks)
{
    std::mt19937 generator(23);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const PlanarModel &model : randomLinkScenes())
    {
        const auto checker = makeFclChecker(model);
        const double safety = 1e-3 * leastExtent(model);
        for (int trial = 0; trial < 4000; ++trial)
        {
            Vector2d a(3 + 6 * uniform(generator), 3 + 6 * uniform(generator));
            double angle = 3.2 * uniform(generator);
            if (trial % 4 == 0)
            {
                a = (10.0 * a).array().round() / 10.0;
                angle = std::round(angle / std::atan(1.0)) * std::atan(1.0);
            }
            const Vector2d b = a + (0.75 + 0.5 * uniform(generator)) * Vector2d(std::cos(angle), std::sin(angle));
            const double distance = supportDistance(model, a, b);
            const double clearance = checker->clearance({a, b, model.arm.radius()});
            SCOPED_TRACE("seed 23, trial " + std::to_string(trial) + ", " + model.obstacles.front().name);
            EXPECT_LE(clearance, std::max(distance, 0.0) + 1e-12);
            EXPECT_GE(clearance, distance - resolved - safety);
            const double margin = std::abs(uniform(generator));
            if (checker->clears({a, b, model.arm.radius() + margin}))
            {
                EXPECT_GT(distance, margin);
            }
            else
            {
                EXPECT_LT(distance, margin + decided + safety);
            }
        }
    }
}

TEST(FclChecker, ServesThreadsAlike)
{
    const PlanarModel model = paperScene(3).model;
    const auto checker = makeFclChecker(model);
    const auto sweep = [&checker](std::vector<double> &clearances)
    {
        for (int i = 0; i < 500; ++i)
            clearances.push_back(checker->clearance({{0.01 * i, 3.0}, {0.01 * i + 0.5, 3.5}, 0.0}));
    };
    std::vector<double> alone, first, second;
    sweep(alone);
    std::thread one(sweep, std::ref(first)), other(sweep, std::ref(second));
    one.join();
    other.join();
    EXPECT_EQ(first, alone);
    EXPECT_EQ(second, alone);
}

double area(const Polygon &polygon)
{
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
    {
        const Vector2d &from = polygon.vertices[i], &to = polygon.vertices[(i + 1) % polygon.vertices.size()];
        doubled += from.x() * to.y() - to.x() * from.y();
    }
    return 0.5 * doubled;
}

TEST(ConvexPieces, CoverAPolygonWithoutOverlap)
{
    std::vector<Polygon> polygons{notched(), {{{0, 0}, {1, 0}, {0, 1}}}};
    polygons.emplace_back();
    for (int i = 0; i < 24; ++i)  // a star
        polygons.back().vertices.emplace_back((i % 2 ? 1 : 3) * std::cos(0.26 * i),
                                              (i % 2 ? 1 : 3) * std::sin(0.26 * i));
    polygons.push_back({{{0, 0}, {0, 1}, {0.5, 0.5}, {1, 1}, {1, 0}}});              // clockwise
    polygons.push_back({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}}});  // straight corners
    for (const Polygon &polygon : polygons)
    {
        double sum = 0.0;
        for (const Polygon &piece : convexPieces(polygon))
        {
            EXPECT_EQ(proof::partsOf({{"piece", piece}}, 100.0).all.size(), 1u) << "a piece is not convex";
            EXPECT_GT(area(piece), 0.0);
            sum += area(piece);
        }
        EXPECT_NEAR(sum, std::abs(area(polygon)), 1e-12);
    }
    EXPECT_EQ(convexPieces(polygons[1]).size(), 1u);
}

TEST(ConvexPieces, RefuseWhatIsNoSimplePolygon)
{
    EXPECT_THROW(convexPieces({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), std::invalid_argument);
    EXPECT_THROW(convexPieces({{{0, 0}, {1, 1}}}), std::invalid_argument);
}

TEST(CircumscribedPolygon, IsCloseAndNeverInside)
{
    for (const Superellipse &shape : {Superellipse{{1, 2}, {1, 1}, 2.0}, Superellipse{{0, 0}, {4.16, 0.316}, 4.0},
                                      Superellipse{{0, 0}, {0.4, 3}, 2.5}, Superellipse{{-1, 0}, {1, 2}, 40.0}})
    {
        const Polygon polygon = circumscribedPolygon(shape, 1e-3);
        EXPECT_LT(polygon.vertices.size(), 300u);
        EXPECT_GT(area(polygon), 0.0);
        const proof::ConvexSet<2> superellipse = proof::partsOf({{"E", shape}}, 100.0).all.front().set;
        double furthest = 0.0;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        {
            const Vector2d &from = polygon.vertices[i], &to = polygon.vertices[(i + 1) % polygon.vertices.size()];
            const Vector2d outward = Vector2d(to.y() - from.y(), from.x() - to.x()).normalized();
            EXPECT_NEAR((from - proof::supportPoint<2>(superellipse, outward)).dot(outward), 0.0, 1e-9)
                << "not a tangent";
            furthest =
                std::max(furthest, proof::separate<2>(superellipse, proof::Segment<2>{from, from}, {1, 0}, {}).upper);
        }
        EXPECT_LE(furthest, 1e-3 * shape.halfExtents.minCoeff());
    }
}
}  // namespace
}  // namespace narrows
