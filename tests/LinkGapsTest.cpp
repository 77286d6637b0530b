// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "kernel/LinkPair.h"
#include "kernel/SegmentDistance.h"
#include "kernel/threading/CentredStep.h"
#include "kernel/threading/LinkGaps.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double radius = 0.02;

/// Two arms on one base: a gripper (link 0, fingers 1 and 2, bent to each other 3 and 4) and a chain 5, 6, 7.
PlanarArm gripperAndChain()
{
    return PlanarArm({0, 0}, {{1.0, -1}, {0.5, 0}, {0.5, 0}, {0.4, 1}, {0.4, 2}, {1.0, -1}, {1.0, 5}, {0.8, 6}},
                     radius);
}

std::shared_ptr<const MidGap> nothing(const PlanarArm &arm)
{
    return std::make_shared<MidGap>(arm, std::vector<Gap>{});
}

/// The gripper points along x, its fingers leave `opening` between their tips, on the x axis; the chain's last
/// link goes in between them from outside, along the axis, 0.3 of it beyond.
VectorXd threaded(double opening)
{
    const double spread = 1.0, bend = std::asin((0.5 * std::sin(spread) - 0.5 * opening) / 0.4);
    const Vector2d middle(1.0 + 0.5 * std::cos(spread) + 0.4 * std::cos(bend), 0.0), base = middle + Vector2d(0.5, 0.0);
    const double towards = std::atan2(base.y(), base.x()), elbow = std::acos(base.norm() / 2.0);
    return VectorXd{{0.0, spread, -spread, -bend, bend, towards - elbow, towards + elbow, M_PI}};
}

TEST(LinkGaps, FindsTheLinkBetweenTwoOthers)
{
    const PlanarArm arm = gripperAndChain();
    const LinkGaps gaps(arm, nothing(arm), 0.1);
    EXPECT_EQ(gaps.gapCount(), 28 - 8);  // pairs less those that meet at a joint or at the base
    const VectorXd q = threaded(0.1);
    std::vector<GapCrossing> crossings;
    gaps.crossings(q, 0.0, crossings);
    ASSERT_EQ(crossings.size(), 1u);
    EXPECT_EQ(crossings[0].link, 7);
    EXPECT_NEAR(gaps.halfWidth(q, crossings[0]), 0.05 - 2.0 * radius, 1e-12);
    EXPECT_EQ(gaps.size(crossings[0]), 0.1);
    VectorXd values;
    Eigen::MatrixXd unused;
    gaps.evaluate(q, crossings, values, unused);
    EXPECT_LT(values.norm(), 1e-12);
    // Closed too far for a link to fit, or as wide as is asked for, it is none.
    gaps.crossings(threaded(4.0 * radius - 1e-9), 0.0, crossings);
    EXPECT_TRUE(crossings.empty());
    LinkGaps(arm, nothing(arm), 0.01 - 1e-9).crossings(q, 0.0, crossings);
    EXPECT_TRUE(crossings.empty());
}

TEST(LinkGaps, MovesWithTheArm)
{
    // The whole robot turned: the gap turns with it, and so does what crosses it.
    const PlanarArm arm = gripperAndChain();
    const LinkGaps gaps(arm, nothing(arm), 0.1);
    const VectorXd q = threaded(0.1), turned = q.array() + 0.7;
    std::vector<GapCrossing> crossings;
    gaps.crossings(turned, 0.0, crossings);
    ASSERT_EQ(crossings.size(), 1u);
    VectorXd values;
    Eigen::MatrixXd jacobian;
    gaps.evaluate(turned, crossings, values, jacobian);
    EXPECT_LT(values.norm(), 1e-12);
    EXPECT_LT((jacobian.transpose() * VectorXd::Ones(8)).norm(), 1e-8);
    EXPECT_GT(jacobian.row(0).norm(), 0.1);  // turning the gripper alone moves the gap
}

TEST(LinkGaps, DifferentiatesByEveryJoint)
{
    const PlanarArm still = gripperAndChain();
    const PlanarArm arm({0, 0}, still.links(), radius, Slide{{0.6, 0.8}, -1.0, 1.0});
    const auto fixed = std::make_shared<MidGap>(arm, std::vector<Gap>{{{0.5, 0.0}, {0.0, 1.0}, 0.05, 0.2}});
    const LinkGaps gaps(arm, fixed, 0.1);
    VectorXd q(9);
    q << 0.0, threaded(0.1);
    std::vector<GapCrossing> crossings;
    gaps.crossings(q, 0.0, crossings);
    ASSERT_EQ(crossings.size(), 2u);
    // Not in the middle any more, and not square.
    q += VectorXd{{0.05, 0.01, -0.02, 0.03, 0.02, -0.01, 0.04, -0.03, 0.05}};
    VectorXd values, after, before;
    Eigen::MatrixXd jacobian, unused;
    gaps.evaluate(q, crossings, values, jacobian);
    ASSERT_EQ(jacobian.cols(), 4);
    constexpr double h = 1e-6;
    for (Eigen::Index joint = 0; joint < q.size(); ++joint)
    {
        const VectorXd step = h * VectorXd::Unit(q.size(), joint);
        gaps.evaluate(q + step, crossings, after, unused);
        gaps.evaluate(q - step, crossings, before, unused);
        EXPECT_LT((jacobian.row(joint).transpose() - (after - before) / (2.0 * h)).norm(), 1e-7) << "joint " << joint;
    }
}

TEST(LinkGaps, CountsFixedGapsFirst)
{
    const PlanarArm arm = gripperAndChain();
    const VectorXd q = threaded(0.1);
    std::vector<Vector2d> points;
    arm.place(q, points);
    const Vector2d middle = 0.5 * (points[6] + points[7]), axis(-0.6, 0.8);
    const auto fixed = std::make_shared<MidGap>(arm, std::vector<Gap>{{middle, axis, 0.05, 0.2}});
    const LinkGaps gaps(arm, fixed, 0.2);
    const std::vector<GapCrossing> crossings{{6, 0, true}, {7, 1 + 0, false}};
    EXPECT_EQ(gaps.halfWidth(q, crossings[0]), 0.05);
    VectorXd values, alone;
    Eigen::MatrixXd jacobian, aloneJacobian;
    gaps.evaluate(q, crossings, values, jacobian);
    fixed->evaluate(q, {crossings[0]}, alone, aloneJacobian);
    ASSERT_EQ(values.size(), 3);
    EXPECT_EQ(values.head(2), alone);
    EXPECT_EQ(jacobian.leftCols(2), aloneJacobian);
    EXPECT_THROW(LinkGaps(arm, nullptr, 0.1), std::invalid_argument);
    EXPECT_THROW(LinkGaps(arm, fixed, 0.0), std::invalid_argument);
}

TEST(LinkGaps, CentredStepKeepsClearOfBothLinks)
{
    const PlanarArm arm = gripperAndChain();
    const LinkGaps gaps(arm, nothing(arm), 0.1);
    const double opening = 4.0 * radius + 2e-4;
    VectorXd q = threaded(opening), tangent, next;
    CentredStep step(gaps);
    std::vector<GapCrossing> crossings;
    const auto segment = [&](const std::vector<Vector2d> &points, int link)
    {
        return std::pair(points[static_cast<std::size_t>(arm.links()[static_cast<std::size_t>(link)].parent + 1)],
                         points[static_cast<std::size_t>(link + 1)]);
    };
    for (int i = 0; i < 10; ++i)
    {
        gaps.crossings(q, 0.0, crossings);
        ASSERT_EQ(crossings.size(), 1u);
        step.begin(q, crossings);
        EXPECT_EQ(step.rank(), 2);
        // The gripper turns; the chain has to follow it.
        step.tangent(0.02 * VectorXd{{1, 1, 1, 1, 1, 0, 0, 0}}, tangent);
        ASSERT_TRUE(step.reach(tangent, next));
        EXPECT_GT((next - q).norm(), 1e-3);
        q = next;
        std::vector<Vector2d> points;
        arm.place(q, points);
        const auto [base, tip] = segment(points, 7);
        for (const int finger : {3, 4})
        {
            const Vector2d end = segment(points, finger).second;
            EXPECT_GT(std::sqrt(squaredDistance(base, tip, end)) - 2.0 * radius, 0.0) << "step " << i;
        }
    }
}
}  // namespace
}  // namespace narrows
