// SPDX-License-Identifier: BSD-3-Clause
// The scaling method against the figures of the paper (Machines 10 (2022) 1030) and of our own reading of it.
#include <cmath>

#include <gtest/gtest.h>

#include "PaperSquare.h"
#include "kernel/Cross.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double step = 5.0;

ScalingOptions optionsOf(ScalingMode mode, double margin)
{
    ScalingOptions options;
    options.mode = mode;
    options.margin = margin;
    options.maxJump = 6.0 * step;
    return options;
}

/// psi_1 .. psi_8 of one pose, in degrees.
std::vector<double> anglesAt(const ScalingProblem &problem, const ScalingResult &result, std::size_t pose)
{
    std::vector<double> angles = linkAngles(problem, result.pose(pose));
    for (double &angle : angles)
        angle = degrees(angle);
    return angles;
}

void expectAngles(const std::vector<double> &angles, const std::vector<double> &printed)
{
    ASSERT_EQ(angles.size(), printed.size());
    for (std::size_t i = 0; i < angles.size(); ++i)
        EXPECT_NEAR(angles[i], printed[i], 0.05) << "psi " << i + 1;
}

TEST(PathScaling, WithoutObstaclesOnlySlideAndFirstAngleChange)
{
    const ScalingProblem problem = paperProblem();
    const PaperSquare square(false, step);
    for (const ScalingMode mode :
         {ScalingMode::PaperNearest, ScalingMode::PaperVertical, ScalingMode::Branch, ScalingMode::Taut})
    {
        const ScalingResult result = scalePath(problem, square.tips(), optionsOf(mode, 100.0));
        ASSERT_FALSE(result.fault);
        ASSERT_EQ(result.poses(), square.tips().size());
        const PathFigures figures = figuresOf(problem, result);
        EXPECT_NEAR(figures.angles[0], 31.65, 0.01);  // the paper: 32
        for (std::size_t i = 1; i < 8; ++i)
            EXPECT_LT(figures.angles[i], 1e-5);
        EXPECT_NEAR(figures.highestSlide, 464.8, 0.05);  // the paper: 465
        EXPECT_NEAR(figures.lowestSlide, -98.4, 0.05);   // the paper: -98
    }
}

TEST(PathScaling, VerticalLinesReproduceTheFirstObstacle)
{
    const ScalingProblem problem = paperObstacle1();
    const PaperSquare square(true, step);
    ScalingOptions options = optionsOf(ScalingMode::PaperVertical, 100.0);
    const ScalingResult result = scalePath(problem, square.tips(), options);
    ASSERT_FALSE(result.fault) << toText(result.fault.failure) << " at " << result.poses();
    ASSERT_EQ(result.poses(), square.tips().size());

    const PathFigures figures = figuresOf(problem, result);
    EXPECT_NEAR(figures.largestAngle, 38.9, 0.05);  // the paper: 39
    EXPECT_NEAR(figures.highestSlide, 537.8, 0.1);  // the paper: 538
    EXPECT_NEAR(figures.lowestSlide, -98.4, 0.05);
    EXPECT_LT(figures.angles[1], 1e-5);  // psi_2 and psi_3 stay 0
    EXPECT_LT(figures.angles[2], 1e-5);
    EXPECT_GT(figures.clearance + 200.0, 265.0);  // the paper: > 265 mm from the cylinder's axis

    expectAngles(anglesAt(problem, result, square.a4()),
                 {anglesAt(problem, result, square.a4())[0], 0.0, 0.0, 0.0, 0.0, 0.0, 6.3, 36.6});
    expectAngles(anglesAt(problem, result, square.a5()), {38.9, 0.0, 0.0, 20.9, 12.0, 7.4, 6.3, 36.6});
    expectAngles(anglesAt(problem, result, square.a6()), {38.9, 0.0, 0.0, 20.9, 2.4, 10.2, 0.0, 0.0});
}

TEST(PathScaling, TheRuleAsPrintedFailsAtTheFirstObstacle)
{
    const PaperSquare square(true, step);
    const ScalingResult result =
        scalePath(paperObstacle1(), square.tips(), optionsOf(ScalingMode::PaperNearest, 100.0));
    EXPECT_TRUE(result.fault);
    EXPECT_GT(result.poses(), square.a4());
    EXPECT_LT(result.poses(), square.a6());
}

TEST(PathScaling, BranchesFindTheSolutionOfTheVerticalLinesByThemselves)
{
    const ScalingProblem problem = paperObstacle1();
    const PaperSquare square(true, step);
    const ScalingResult result = scalePath(problem, square.tips(), optionsOf(ScalingMode::Branch, 100.0));
    ASSERT_FALSE(result.fault) << toText(result.fault.failure) << " at " << result.poses();
    const PathFigures figures = figuresOf(problem, result);
    EXPECT_NEAR(figures.largestAngle, 39.0, 0.1);
    EXPECT_NEAR(figures.highestSlide, 538.0, 0.5);
}

TEST(PathScaling, TautStringNeedsSmallerAngles)
{
    const ScalingProblem problem = paperObstacle1();
    const PaperSquare square(true, step);
    const ScalingResult result = scalePath(problem, square.tips(), optionsOf(ScalingMode::Taut, 99.0));
    ASSERT_FALSE(result.fault) << toText(result.fault.failure) << " at " << result.poses();
    const PathFigures figures = figuresOf(problem, result);
    EXPECT_NEAR(figures.largestAngle, 32.0, 0.1);  // 38.9 with the paper's rule
    EXPECT_NEAR(figures.highestSlide, 473.0, 0.5);
    EXPECT_GT(figures.clearance, 61.5);
}

TEST(PathScaling, TipIsWhereItShallBe)
{
    const ScalingProblem problem = paperObstacle1();
    const PaperSquare square(true, step);
    const ScalingResult result = scalePath(problem, square.tips(), optionsOf(ScalingMode::Taut, 99.0));
    ASSERT_EQ(result.poses(), square.tips().size());
    for (std::size_t p = 0; p < result.poses(); ++p)
    {
        EXPECT_EQ(result.pose(p)[8], square.tips()[p]);
        EXPECT_EQ(result.pose(p)[0].tail<2>(), Vector2d::Zero());
    }
}

TEST(PathScaling, TipsMayEnterTheRegionOfWhatIsBehindThem)
{
    ScalingProblem problem = paperProblem();
    problem.sections.emplace_back(std::vector<Vector2d>{{500.0, 100.0}}, 150.0, Interval{1200.0, 1800.0});
    std::vector<Vector3d> tips{{3126.0, 0.0, 0.0}};
    appendLeg({{0.0, 0.0}, {600.0, 0.0}}, 3126.0, step, 0.0, tips);
    ScalingOptions options = optionsOf(ScalingMode::Taut, 100.0);
    EXPECT_EQ(scalePath(problem, tips, options).fault.failure, ScalingFailure::TipBlocked);
    options.behind = {true};
    const ScalingResult result = scalePath(problem, tips, options);
    EXPECT_FALSE(result.fault) << toText(result.fault.failure) << " at " << result.poses();
    ASSERT_EQ(result.poses(), tips.size());
    EXPECT_EQ(result.pose(tips.size() - 1)[8], tips.back());
    options.behind = {true, false};
    EXPECT_THROW(scalePath(problem, tips, options), std::invalid_argument);
}

TEST(PathScaling, LateStartLeavesOutWhatCannotBeHad)
{
    const ScalingProblem problem = paperObstacle1();
    std::vector<Vector3d> tips{{3126.0, -2500.0, 0.0}};
    appendLeg({{-2500.0, 0.0}, {-1500.0, 0.0}}, 3126.0, step, 0.0, tips);
    ScalingOptions options = optionsOf(ScalingMode::Taut, 100.0);
    EXPECT_EQ(scalePath(problem, tips, options).fault.failure, ScalingFailure::Reach);
    options.lateStart = true;
    const ScalingResult result = scalePath(problem, tips, options);
    EXPECT_FALSE(result.fault);
    EXPECT_EQ(result.first, 78U);  // 2500 - 78 * 5 = 2110, the first below 3126 sin 42.5 = 2111.9
    ASSERT_EQ(result.poses(), tips.size() - 78U);
    EXPECT_EQ(result.pose(0)[8], tips[78]);
}

TEST(PathScaling, TopViewPassesTheThirdObstacle)
{
    const ScalingProblem problem = paperObstacle3();
    const PaperSquare square(false, step);
    for (const double margin : {65.0, 100.0})
    {
        const ScalingResult result = scalePath(problem, square.tips(), optionsOf(ScalingMode::Taut, margin));
        ASSERT_FALSE(result.fault) << toText(result.fault.failure) << " at " << result.poses();
        const PathFigures figures = figuresOf(problem, result);
        EXPECT_NEAR(figures.angles[0], margin < 100.0 ? 26.6 : 26.5, 0.1);
        EXPECT_NEAR(figures.angles[3], margin < 100.0 ? 15.4 : 17.0, 0.1);
        EXPECT_NEAR(figures.angles[4], figures.angles[3], 1e-6);
        for (const std::size_t unmoved : {1, 2, 5, 6, 7})  // six rotational degrees of freedom move
            EXPECT_LT(figures.angles[unmoved], 1e-5) << unmoved;
        double nearest = 1e300;
        for (std::size_t i = 0; i < result.centres.size(); ++i)
            if ((i + 1) % result.stride != 0)
                for (double t = 0.0; t <= 1.0; t += 0.05)
                {
                    const Vector3d point = (1.0 - t) * result.centres[i] + t * result.centres[i + 1];
                    nearest = std::min(nearest, std::hypot(point.x() - 2126.0, point.y() - 600.0));
                }
        EXPECT_GT(nearest, 264.0);
        EXPECT_NEAR(figures.highestSlide, margin < 100.0 ? 537.0 : 556.0, 1.0);
    }
}
}  // namespace
}  // namespace narrows
