// SPDX-License-Identifier: BSD-3-Clause
// Every way in which scaling fails has its name.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "PaperSquare.h"
#include "kernel/scaling/PoseRules.h"
#include "kernel/scaling/TipRoutes.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

class ScalingFailures : public testing::Test
{
protected:
    static ScalingOptions wideOptions()
    {
        ScalingOptions result;
        result.margin = 100.0;
        return result;
    }
    ScalingResult scale(const std::vector<Vector2d> &corners)
    {
        std::vector<Vector3d> tips{{3126.0, corners[0].x(), corners[0].y()}};
        for (std::size_t i = 1; i < corners.size(); ++i)
            appendLeg({corners[i - 1], corners[i]}, 3126.0, 5.0, 0.0, tips);
        options.maxJump = maxJump;
        return scalePath(problem, tips, options);
    }
    void addDisc(double y, double z, double radius)
    {
        problem.sections.emplace_back(std::vector<Vector2d>{{y, z}}, radius);
    }

    ScalingProblem problem = paperProblem();
    ScalingOptions options = wideOptions();
    double maxJump = 30.0;
};

TEST_F(ScalingFailures, Reach)
{
    // 3126 sin 42.5 = 2111.9
    const ScalingResult result = scale({{2000.0, 0.0}, {2200.0, 0.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::Reach);
    EXPECT_EQ(result.poses(), 23U);  // up to 2110
}

TEST_F(ScalingFailures, Slide)
{
    problem.slide = {-100.0, 100.0};
    // x_0 = 3126 - sqrt(3126^2 - 800^2) = 104.1
    const ScalingResult result = scale({{0.0, 0.0}, {800.0, 0.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::Slide);
    EXPECT_NEAR(result.pose(result.poses() - 1)[0].x(), 100.0, 1.5);
}

TEST_F(ScalingFailures, BaseBlocked)
{
    addDisc(0.0, 150.0, 100.0);
    const ScalingResult result = scale({{500.0, 0.0}, {600.0, 0.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::BaseBlocked);
    EXPECT_EQ(result.fault.section, 0);
    EXPECT_EQ(result.poses(), 0U);
}

TEST_F(ScalingFailures, TipBlocked)
{
    addDisc(1000.0, 0.0, 200.0);
    const ScalingResult result = scale({{0.0, 0.0}, {1000.0, 0.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::TipBlocked);
    EXPECT_EQ(result.poses(), 141U);  // 0, 5, ..., 700: the boundary
}

TEST_F(ScalingFailures, NoCandidate)
{
    options.mode = ScalingMode::PaperNearest;
    // P_8 = 0.909 * (1100, 0) is inside the region in the middle; its hits are inside the others.
    const Vector2d p8(1100.0 * 2842.0 / 3126.0, 0.0);
    addDisc(p8.x(), p8.y(), 10.0);
    for (const Vector2d &off :
         {Vector2d(110.0, 0.0), Vector2d(-110.0, 0.0), Vector2d(0.0, 110.0), Vector2d(0.0, -110.0)})
        addDisc(p8.x() + off.x(), p8.y() + off.y(), 5.0);
    const ScalingResult result = scale({{1100.0, 0.0}, {1100.0, 1.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::NoCandidate);
    EXPECT_EQ(result.fault.link, 7);
}

TEST_F(ScalingFailures, Span)
{
    options.mode = ScalingMode::PaperVertical;
    addDisc(1000.0, 0.0, 400.0);
    // P_8' = (1364, 0), its hits along z at +-343, 369 from the tip: longer than the last link, 284.
    const ScalingResult result = scale({{1500.1, 0.0}, {1510.0, 0.0}});
    EXPECT_EQ(result.fault.failure, ScalingFailure::Span);
    EXPECT_EQ(result.fault.link, 7);
}

// Wide limits hold too: link 2 lies back on link 1 but for 0.05 rad.
TEST(PoseRules, KeepLinkAnglesUpToHalfATurn)
{
    ScalingProblem problem;
    problem.lengths = {1.0, 1.0};
    const double bend = std::acos(-1.0) - 0.05;
    const std::vector<Eigen::Vector3d> centres{{0, 0, 0}, {1, 0, 0}, {1 + std::cos(bend), std::sin(bend), 0}};
    problem.maxAngle = bend - 0.01;
    EXPECT_EQ(PoseRules(problem).check(centres.data()).failure, ScalingFailure::LinkAngle);
    problem.maxAngle = bend + 0.01;
    EXPECT_EQ(PoseRules(problem).check(centres.data()).failure, ScalingFailure::None);
}

TEST_F(ScalingFailures, LinkAngleUnlessEased)
{
    problem.maxAngle = 0.4;
    addDisc(500.0, 0.0, 200.0);
    // A straight arm would need asin(1200 / 3126) = 0.394; the string around the obstacle is longer.
    const std::vector<Vector2d> corners{{0.0, 1199.0}, {1100.0, 479.0}};
    options.easing = 0;
    EXPECT_EQ(scale(corners).fault.failure, ScalingFailure::LinkAngle);
    options.easing = 40;
    const ScalingResult eased = scale(corners);
    EXPECT_FALSE(eased.fault) << toText(eased.fault.failure);
    EXPECT_LE(figuresOf(problem, eased).largestAngle, degrees(0.4));
}

TEST_F(ScalingFailures, LinkClearanceUnlessEased)
{
    addDisc(450.0, 450.0, 60.0);
    options.margin = 65.0;
    options.easing = 0;
    const std::vector<Vector2d> corners{{0.0, 1500.0}, {1100.0, 1000.0}, {1500.0, 200.0}};
    const ScalingResult cut = scale(corners);
    EXPECT_EQ(cut.fault.failure, ScalingFailure::LinkClearance);
    EXPECT_EQ(cut.fault.section, 0);
    options.easing = 40;
    const ScalingResult eased = scale(corners);
    EXPECT_FALSE(eased.fault) << toText(eased.fault.failure);
    EXPECT_GT(eased.poses(), cut.poses());
    EXPECT_GE(figuresOf(problem, eased).clearance, 61.5);
}

TEST_F(ScalingFailures, Jump)
{
    maxJump = 1.0;  // every joint but the first ones moves more while the tip moves 5
    for (const ScalingMode mode :
         {ScalingMode::PaperNearest, ScalingMode::PaperVertical, ScalingMode::Branch, ScalingMode::Taut})
    {
        options.mode = mode;
        const ScalingResult result = scale({{0.0, 0.0}, {500.0, 0.0}});
        EXPECT_EQ(result.fault.failure, ScalingFailure::Jump);
        EXPECT_EQ(result.poses(), 1U);
    }
}

TEST_F(ScalingFailures, Overlap)
{
    const std::vector<ConvexSection> sections{ConvexSection({{600.0, 0.0}}, 100.0),
                                              ConvexSection({{950.0, 0.0}}, 100.0)};
    const Vector2d notch(775.0, 140.0);
    EXPECT_EQ(TipRoutes(sections, {100.0, 100.0}, {Vector2d::Zero(), notch}).fault().failure, ScalingFailure::Overlap);
    EXPECT_EQ(TipRoutes(sections, {60.0, 60.0}, {Vector2d::Zero(), notch}).fault().failure, ScalingFailure::None);
    EXPECT_EQ(TipRoutes(sections, {60.0, 60.0}, {Vector2d::Zero(), {600.0, 10.0}}).fault().failure,
              ScalingFailure::TipBlocked);
}

TEST_F(ScalingFailures, HaveNamesOfTheirOwn)
{
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(ScalingFailure::Overlap); ++i)
        names.insert(toText(static_cast<ScalingFailure>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(ScalingFailure::Overlap) + 1);
    EXPECT_EQ(toText(ScalingFailure::None), "");
}

TEST_F(ScalingFailures, BadInputIsRefused)
{
    options.margin = 61.0;  // less than the radius
    EXPECT_THROW(scale({{0.0, 0.0}, {5.0, 0.0}}), std::invalid_argument);
    options.margin = 100.0;
    maxJump = 0.0;
    EXPECT_THROW(scale({{0.0, 0.0}, {5.0, 0.0}}), std::invalid_argument);
    maxJump = 30.0;
    problem.maxAngle = -0.1;
    EXPECT_THROW(scale({{0.0, 0.0}, {5.0, 0.0}}), std::invalid_argument);
    problem = paperProblem();
    problem.lengths[3] = 0.0;
    EXPECT_THROW(scale({{0.0, 0.0}, {5.0, 0.0}}), std::invalid_argument);
    problem.lengths.clear();
    EXPECT_THROW(scale({{0.0, 0.0}, {5.0, 0.0}}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
