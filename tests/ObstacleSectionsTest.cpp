// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ObstacleSections.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "HyperRedundantArm.h"
#include "SpatialScenes.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

ScalingProblem projected(const std::vector<SpatialObstacle> &obstacles, const ChainGeometry &chain)
{
    ScalingProblem problem = scalingProblem(chain);
    addObstacles(obstacles, chain, problem);
    return problem;
}

ScalingProblem projected(const decltype(SpatialObstacle::shape) &shape)
{
    return projected({{"it", shape}}, *chainGeometry(hyperRedundantArm()));
}

TEST(ObstacleSections, WhatLiesAlongTheSlideIsProjectedExactly)
{
    const ScalingProblem pipe = projected(Cylinder{{500.0, 700.0, 600.0}, -Vector3d::UnitX(), 200.0, 300.0});
    ASSERT_EQ(pipe.sections.size(), 1U);
    EXPECT_EQ(pipe.sections[0].corners(), std::vector<Vector2d>{Vector2d(700.0, 600.0)});
    EXPECT_EQ(pipe.sections[0].radius(), 200.0);
    EXPECT_EQ(pipe.sections[0].span().lower, 200.0);
    EXPECT_EQ(pipe.sections[0].span().upper, 800.0);

    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
    const ScalingProblem prism = projected(Prism{{{400.0, 800.0}, {100.0, 200.0}, {700.0, 200.0}}, pose, infinity});
    ASSERT_EQ(prism.sections.size(), 1U);
    EXPECT_EQ(prism.sections[0].corners().size(), 3U);
    EXPECT_EQ(prism.sections[0].distance({400.0, 100.0}), 100.0);
    EXPECT_EQ(prism.sections[0].span().upper, infinity);

    const ScalingProblem ball = projected(Sphere{{3000.0, 100.0, 400.0}, 50.0});
    EXPECT_EQ(ball.sections.at(0).distance({100.0, 500.0}), 50.0);
    EXPECT_EQ(ball.sections.at(0).span().lower, 2950.0);
}

TEST(ObstacleSections, LongBarsAcrossTheSlideAreCrossbars)
{
    const ScalingProblem bar = projected(Cylinder{{2126.0, 600.0, 50.0}, Vector3d::UnitZ(), 200.0, infinity});
    EXPECT_TRUE(bar.sections.empty());
    ASSERT_EQ(bar.crossbars.size(), 1U);
    EXPECT_EQ(bar.crossbars[0].x, 2126.0);
    EXPECT_EQ(bar.crossbars[0].offset * bar.crossbars[0].across, Vector2d(600.0, 0.0));
    EXPECT_EQ(bar.crossbars[0].radius, 200.0);
    // A short one can be gone round.
    const ScalingProblem shortBar = projected(Cylinder{{2126.0, 600.0, 50.0}, Vector3d::UnitZ(), 200.0, 900.0});
    EXPECT_TRUE(shortBar.crossbars.empty());
    ASSERT_EQ(shortBar.sections.size(), 1U);
    EXPECT_EQ(shortBar.sections[0].distance({600.0, 949.0}), 0.0);
    EXPECT_NEAR(shortBar.sections[0].distance({600.0, 960.0}), 10.0, 1e-9);
    EXPECT_NEAR(shortBar.sections[0].distance({900.0, 0.0}), 100.0, 0.5);  // the circle is a polygon around it
}

TEST(ObstacleSections, WhatIsOutOfReachIsLeftOut)
{
    EXPECT_TRUE(projected(Sphere{{0.0, 3500.0, 0.0}, 50.0}).sections.empty());
    EXPECT_TRUE(projected(Sphere{{4300.0, 0.0, 100.0}, 50.0}).sections.empty());  // 1000 + 3126 + 61.5 in x
    EXPECT_EQ(projected(Sphere{{4200.0, 0.0, 100.0}, 50.0}).sections.size(), 1U);
}

TEST(ObstacleSections, ContainTheirObstacles)
{
    const ChainGeometry chain = *chainGeometry(snake());
    const Eigen::Matrix3d axes = slideAxes(chain);
    std::mt19937 generator(7);
    int inside = 0;
    for (int i = 0; i < 120; ++i)
    {
        const SpatialObstacle obstacle = randomObstacle(i % obstacleKinds, generator);
        const ScalingProblem problem = projected({obstacle}, chain);
        if (!problem.crossbars.empty())
            continue;
        ASSERT_EQ(problem.sections.size(), 1U) << obstacle.name;
        const ConvexSection &section = problem.sections[0];
        for (int k = 0; k < 400; ++k)
        {
            const Vector3d point = randomPoint(1.5, generator);
            if (nearnessOf(obstacle, point, point).distance > 0.0)
                continue;
            ++inside;
            const Vector3d local = axes.transpose() * (point - chain.origin);
            EXPECT_LE(section.distance(local.tail<2>()), 1e-12) << obstacle.name;
            EXPECT_GE(local.x(), section.span().lower - 1e-12) << obstacle.name;
            EXPECT_LE(local.x(), section.span().upper + 1e-12) << obstacle.name;
        }
    }
    EXPECT_GT(inside, 2000);
}
}  // namespace
}  // namespace narrows
