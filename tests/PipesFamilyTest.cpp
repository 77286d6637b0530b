// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/Scenario.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

PipeScene draw(int obstacles, int seed, const std::string &margin = "100")
{
    const Family &family = findFamily("pipes");
    const FamilyValues values =
        family.values({{"obstacles", std::to_string(obstacles)}, {"seed", std::to_string(seed)}, {"margin", margin}});
    return std::get<PipeScene>(family.draw(values));
}

/// The boundary of a section, as many points of it: an oracle for distances that are not small.
struct Boundary
{
    std::vector<Vector2d> operator()(const Cylinder &pipe) const
    {
        std::vector<Vector2d> points;
        for (int i = 0; i < 720; ++i)
            points.push_back(Vector2d(pipe.center.tail<2>()) +
                             pipe.radius * Vector2d(std::cos(i * M_PI / 360.0), std::sin(i * M_PI / 360.0)));
        return points;
    }
    std::vector<Vector2d> operator()(const Prism &prism) const
    {
        std::vector<Vector2d> points;
        for (std::size_t i = 0; i < prism.vertices.size(); ++i)
            for (int k = 0; k < 200; ++k)
                points.push_back(prism.vertices[i] +
                                 k / 200.0 * (prism.vertices[(i + 1) % prism.vertices.size()] - prism.vertices[i]));
        return points;
    }
};

double sampledDistance(const std::vector<Vector2d> &one, const std::vector<Vector2d> &other)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Vector2d &a : one)
        for (const Vector2d &b : other)
            least = std::min(least, (a - b).norm());
    return least;
}

struct ExpectSizes
{
    int &prisms;

    void operator()(const Cylinder &pipe) const
    {
        EXPECT_GE(pipe.radius, 80.0);
        EXPECT_LE(pipe.radius, 200.0);
        EXPECT_LE(pipe.center.norm(), 1300.001);
        EXPECT_EQ(pipe.axis, Eigen::Vector3d::UnitX());
        EXPECT_TRUE(std::isinf(pipe.halfLength));
    }
    /// The corners are on one circle, so that any three of them tell its radius.
    void operator()(const Prism &prism) const
    {
        ++prisms;
        const std::vector<Vector2d> &v = prism.vertices;
        ASSERT_GE(v.size(), 3u);
        ASSERT_LE(v.size(), 6u);
        for (std::size_t i = 0; i < v.size(); ++i)
        {
            const Vector2d a = v[(i + 1) % v.size()] - v[i], b = v[(i + 2) % v.size()] - v[i];
            const double twiceArea = a.x() * b.y() - a.y() * b.x();
            EXPECT_GT(twiceArea, 0.0) << "convex, counter-clockwise";
            const double radius = a.norm() * b.norm() * (b - a).norm() / (2.0 * twiceArea);
            EXPECT_GE(radius, 109.9);
            EXPECT_LE(radius, 230.1);
        }
        EXPECT_TRUE(std::isinf(prism.halfLength));
    }
};

TEST(Pipes, KeepTheirPromises)
{
    int prisms = 0;
    for (int count = 1; count <= 3; ++count)
        for (int seed = 1; seed <= 60; ++seed)
        {
            SCOPED_TRACE(testing::Message() << count << " obstacles, seed " << seed);
            const PipeScene scene = draw(count, seed);
            ASSERT_EQ(scene.sections.size(), static_cast<std::size_t>(count));
            ASSERT_EQ(scene.tips.size(), 3u);
            for (const Vector2d &tip : scene.tips)
                EXPECT_LE(tip.norm(), 1700.001);
            for (std::size_t i = 0; i < scene.sections.size(); ++i)
            {
                std::visit(ExpectSizes{prisms}, scene.sections[i]);
                const std::vector<Vector2d> boundary = std::visit(Boundary{}, scene.sections[i]);
                EXPECT_GE(sampledDistance(boundary, scene.tips), 102.0 - 1e-6);
                EXPECT_GE(sampledDistance(boundary, {Vector2d::Zero()}), 102.0 - 1e-6);
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_GE(sampledDistance(boundary, std::visit(Boundary{}, scene.sections[j])), 220.0 - 1e-6);
            }
        }
    EXPECT_GT(prisms, 120);
    EXPECT_LT(prisms, 240);
}

TEST(Pipes, DistancesAreThoseOfTheBoundariesUnlessSectionsMeet)
{
    const PipeScene::Section square = prismOver({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_DOUBLE_EQ(distance(square, Vector2d(13, 14)), 5.0);
    EXPECT_DOUBLE_EQ(distance(square, Vector2d(4, 5)), -4.0);
    EXPECT_DOUBLE_EQ(distance(square, pipeAround({13, 14}, 2.0)), 3.0);
    EXPECT_DOUBLE_EQ(distance(pipeAround({0, 0}, 1.0), pipeAround({3, 4}, 2.0)), 2.0);
    EXPECT_DOUBLE_EQ(distance(square, prismOver({{12, 5}, {20, -10}, {20, 20}})), 2.0);
    // One within the other, either way.
    const PipeScene::Section speck = prismOver({{4, 4}, {6, 4}, {5, 6}}), dot = pipeAround({5, 5}, 1.0);
    for (const PipeScene::Section &inner : {speck, dot})
    {
        EXPECT_LT(distance(square, inner), 0.0);
        EXPECT_LT(distance(inner, square), 0.0);
    }
}

TEST(Pipes, FilesAreReadBackBitByBit)
{
    for (int seed = 1; seed <= 20; ++seed)
    {
        const PipeScene scene = draw(3, seed);
        const Scenario scenario = parseScenario(toYaml(scene, "pipes", "a: b"), "text");
        const SpatialWorld &world = scenario.spatial();
        EXPECT_EQ(scenario.source, "a: b");
        EXPECT_TRUE(world.task.start.isZero(0.0));
        EXPECT_DOUBLE_EQ(world.model->arm.universalLimits().at(7).maxAngle, 42.5 * M_PI / 180.0);
        EXPECT_EQ(world.model->arm.links().at(7).radius, PipeScene::armRadius);
        ASSERT_EQ(world.model->obstacles.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto &shape = world.model->obstacles[i].shape;
            if (const auto *pipe = std::get_if<Cylinder>(&scene.sections[i]))
            {
                EXPECT_EQ(std::get<Cylinder>(shape).center, pipe->center);
                EXPECT_EQ(std::get<Cylinder>(shape).radius, pipe->radius);
                continue;
            }
            const auto &prism = std::get<Prism>(scene.sections[i]);
            EXPECT_EQ(std::get<Prism>(shape).vertices, prism.vertices);
            EXPECT_TRUE(std::get<Prism>(shape).pose.isApprox(prism.pose, 0.0));
        }
        const auto &goal = std::get<SpatialTipPath>(world.task.goal);
        ASSERT_EQ(goal.points.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(goal.points[i], Eigen::Vector3d(3126.0, scene.tips[i].x(), scene.tips[i].y()));
        EXPECT_EQ(goal.link, 7);
        EXPECT_EQ(goal.tolerance, 1e-3);
    }
}

TEST(Pipes, ThinMarginsStillLeaveRoomForTheArm)
{
    for (int seed = 1; seed <= 60; ++seed)
        EXPECT_NO_THROW(parseScenario(toYaml(draw(3, seed, "0"), "pipes", "thin"), "text")) << seed;
}

TEST(Pipes, SayWhenNoSceneFits)
{
    try
    {
        draw(10, 1, "500");
        ADD_FAILURE() << "ten regions of that size do not fit";
    }
    catch (const std::invalid_argument &error)
    {
        EXPECT_STREQ(error.what(), "no such scene was found in 20000 draws");
    }
}
}  // namespace
}  // namespace narrows
