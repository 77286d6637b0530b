// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "kernel/SegmentDistance.h"
#include "kernel/threading/CentredStep.h"
#include "kernel/threading/MidGap.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double radius = 0.3;

/// Three links; the last one can lie in a gap between two circles above and below (2, 0.5).
struct Scene
{
    explicit Scene(double halfWidth)
      : circles{{{2.0, 0.5 + radius + halfWidth}, radius}, {{2.0, 0.5 - radius - halfWidth}, radius}},
        midGap(PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}}),
               findGaps({{"above", circles[0]}, {"below", circles[1]}}, 0.0, 0.2))
    {
    }

    /// Least distance of a link from a circle, negative inside.
    double clearance(const VectorXd &q) const
    {
        std::vector<Vector2d> points;
        midGap.arm().place(q, points);
        double least = std::numeric_limits<double>::infinity();
        for (int link = 0; link < 3; ++link)
            for (const Circle &circle : circles)
                least = std::min(
                    least, std::sqrt(squaredDistance(points[link], points[link + 1], circle.center)) - circle.radius);
        return least;
    }

    /// The third link crosses the gap straight and has its base at (x, 0.5); the elbow is below.
    VectorXd across(double x) const
    {
        const double distance = std::hypot(x, 0.5), direction = std::atan2(0.5, x), bend = std::acos(distance / 2.0);
        return VectorXd{{direction - bend, direction + bend, 0.0}};
    }

    std::vector<GapCrossing> crossings(const VectorXd &q, double lengthening = 0.0) const
    {
        std::vector<Vector2d> points;
        midGap.arm().place(q, points);
        std::vector<GapCrossing> result;
        midGap.crossings(points, lengthening, result);
        return result;
    }

    VectorXd values(const VectorXd &q, const std::vector<GapCrossing> &which) const
    {
        std::vector<Vector2d> points;
        midGap.arm().place(q, points);
        VectorXd result;
        Eigen::MatrixXd jacobian;
        midGap.evaluate(points, which, result, jacobian);
        return result;
    }

    std::vector<Circle> circles;
    MidGap midGap;
};

TEST(MidGap, FindsTheLinkInTheGap)
{
    const Scene scene(1e-3);
    const auto crossings = scene.crossings(scene.across(1.5));
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_EQ(crossings[0].link, 2);
    EXPECT_TRUE(crossings[0].square);
    // Drawn back, the link ends 0.1 before the gap: it crosses it only if it is taken for longer, by 0.1 or more.
    EXPECT_TRUE(scene.crossings(scene.across(0.9)).empty());
    EXPECT_TRUE(scene.crossings(scene.across(0.9), 0.1 / radius - 1e-6).empty());
    EXPECT_EQ(scene.crossings(scene.across(0.9), 0.1 / radius + 1e-6).size(), 1u);
}

TEST(MidGap, EquationsAreDistanceAndTilt)
{
    const Scene scene(1e-3);
    const std::vector<GapCrossing> last{{2, 0, true}};
    EXPECT_LT(scene.values(scene.across(1.5), last).norm(), 1e-12);
    VectorXd turned = scene.across(1.5);
    turned[2] += 0.2;  // about a base 0.5 before the middle
    const VectorXd values = scene.values(turned, last);
    EXPECT_NEAR(values[0], -0.5 * std::sin(0.2), 1e-12);
    EXPECT_NEAR(std::abs(values[1]), std::sin(0.2), 1e-12);
}

TEST(MidGap, DerivativeAgreesWithDifferences)
{
    const PlanarArm gripper({0.1, 0.2}, {{1.0, -1}, {0.8, 0}, {0.6, 1}, {0.7, 1}}, 0.01, Slide{{0.6, 0.8}, -1.0, 1.0});
    const MidGap midGap(gripper, findGaps({{"a", Circle{{2, 1}, 0.4}}, {"b", Circle{{2, 0}, 0.5}}}, 0.01, 1.0));
    const std::vector<GapCrossing> crossings{{3, 0, true}, {1, 0, false}, {2, 0, true}};
    const VectorXd q{{0.3, 0.2, -0.4, 0.7, 0.1}};
    std::vector<Vector2d> points;
    VectorXd values, other;
    Eigen::MatrixXd jacobian, unused;
    gripper.place(q, points);
    midGap.evaluate(points, crossings, values, jacobian);
    ASSERT_EQ(values.size(), 5);
    constexpr double step = 1e-6;
    for (int j = 0; j < 5; ++j)
    {
        gripper.place(q + step * VectorXd::Unit(5, j), points);
        midGap.evaluate(points, crossings, other, unused);
        VectorXd difference = other;
        gripper.place(q - step * VectorXd::Unit(5, j), points);
        midGap.evaluate(points, crossings, other, unused);
        difference = (difference - other) / (2.0 * step);
        EXPECT_LT((difference - jacobian.row(j).transpose()).norm(), 1e-9) << "joint " << j;
    }
}

TEST(CentredStep, FollowsTheClosedFormOfTheSlide)
{
    const Scene scene(1e-4);
    CentredStep step(scene.midGap);
    VectorXd q = scene.across(1.5), tangent, next;
    double x = 1.5;
    for (int i = 0; i < 20; ++i)
    {
        step.begin(q, {{2, 0, true}});
        EXPECT_EQ(step.rank(), 2);
        step.tangent(scene.across(x - 0.05) - q, tangent);
        ASSERT_TRUE(step.reach(tangent, next));
        q = next;
        x = std::cos(q[0]) + std::cos(q[1]);
        EXPECT_LT((q - scene.across(x)).norm(), 1e-6);
        EXPECT_GT(scene.clearance(q), 0.99e-4);
    }
    EXPECT_LT(x, 1.4);
}

// The ablation of docs/threader.md: with F1 alone a link is held that is tilted until it touches.
TEST(CentredStep, DistanceAloneHoldsTiltedLinks)
{
    const Scene scene(1e-4);
    CentredStep step(scene.midGap);
    VectorXd tilted = scene.across(1.5), next;
    tilted[2] += 0.15;
    step.begin(tilted, {{2, 0, false}});
    ASSERT_TRUE(step.reach(VectorXd::Zero(3), next));
    EXPECT_LT(scene.clearance(next), 0.0);
    step.begin(tilted, {{2, 0, true}});
    ASSERT_TRUE(step.reach(VectorXd::Zero(3), next));
    EXPECT_GT(scene.clearance(next), 0.99e-4);
}

TEST(CentredStep, LeavesOutWhatDependsOnOtherEquations)
{
    // Two links of one line through the gap, where they meet: F1 and F2 of both are three equations.
    const Scene scene(1e-3);
    const MidGap midGap(PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}, {1.0, 2}}), scene.midGap.gaps());
    CentredStep step(midGap);
    VectorXd q(4);
    q << scene.across(1.0), 0.0;
    step.begin(q, {{2, 0, true}, {3, 0, true}});
    EXPECT_EQ(step.rank(), 3);
    VectorXd tangent, next;
    step.tangent(VectorXd::Unit(4, 0), tangent);
    EXPECT_GT(tangent.norm(), 0.1);
    // The line slides on, which turns the first two links only.
    EXPECT_LT(tangent.tail(2).norm(), 1e-12);
    ASSERT_TRUE(step.reach(0.05 * tangent.normalized(), next));
    EXPECT_LT(next.tail(2).norm(), 1e-4);
}

TEST(CentredStep, SaysWhenItDoesNotGetThere)
{
    const Scene scene(1e-3);
    CentredStep step(scene.midGap);
    // Square to the line from its base to the middle, the first link's F1 is as far off as it can be.
    const VectorXd away{{std::atan2(0.5, 2.0) + M_PI / 2.0, 0.0, 0.0}};
    step.begin(away, {{0, 0, false}});
    VectorXd next;
    EXPECT_FALSE(step.reach(VectorXd::Zero(3), next));
}
}  // namespace
}  // namespace narrows
