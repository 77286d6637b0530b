// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialArm.h"

#include <gtest/gtest.h>

#include "SpatialRobots.h"

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Kind = SpatialJoint::Kind;

const double pi = std::acos(-1.0);

class EveryRobot : public testing::TestWithParam<int>
{
protected:
    const SpatialArm arm_ = GetParam() == 0 ? snake() : GetParam() == 1 ? sixAxisArm() : gantryHand();
    std::mt19937 generator_{7};

    SpatialArm::Placement placeAt(const VectorXd &q) const
    {
        SpatialArm::Placement placement;
        arm_.place(q, placement);
        return placement;
    }
};

TEST_P(EveryRobot, PlacesJointsOneMotionAfterTheOther)
{
    const VectorXd q = randomVector(arm_.dimension(), 3.0, generator_);
    const SpatialArm::Placement placement = placeAt(q);
    for (int i = 0; i < arm_.dimension(); ++i)
    {
        const SpatialJoint &joint = arm_.joints()[i];
        Isometry3d expected = joint.parent < 0 ? Isometry3d::Identity() : placement.frames[joint.parent];
        expected = expected * joint.offset;
        if (joint.kind == Kind::Revolute)
            expected = expected * Eigen::AngleAxisd(q[i], joint.axis);
        else
            expected = expected * Eigen::Translation3d(q[i] * joint.axis);
        EXPECT_LT((placement.frames[i].matrix() - expected.matrix()).norm(), 1e-14) << "joint " << i;
    }
    for (int i = 0; i < arm_.linkCount(); ++i)
    {
        const SpatialLink &link = arm_.links()[i];
        const Isometry3d frame = link.joint < 0 ? Isometry3d::Identity() : placement.frames[link.joint];
        EXPECT_LT((placement.points[2 * i] - frame * link.from).norm(), 1e-15);
        EXPECT_LT((placement.points[2 * i + 1] - frame * link.to).norm(), 1e-15);
    }
}

TEST_P(EveryRobot, VelocitiesAndSpinsAreDerivatives)
{
    const VectorXd q = randomVector(arm_.dimension(), 2.0, generator_);
    const VectorXd delta = randomVector(arm_.dimension(), 1.0, generator_);
    std::vector<Vector3d> points, spins;
    arm_.velocities(placeAt(q), delta, points, spins);
    constexpr double h = 1e-6;
    const SpatialArm::Placement before = placeAt(q - h * delta), after = placeAt(q + h * delta);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LT((points[i] - (after.points[i] - before.points[i]) / (2.0 * h)).norm(), 1e-8) << i;
    for (int i = 0; i < arm_.linkCount(); ++i)
        EXPECT_LT((points[2 * i + 1] - points[2 * i] -
                   spins[i].cross(placeAt(q).points[2 * i + 1] - placeAt(q).points[2 * i]))
                      .norm(),
                  1e-13);
}

TEST_P(EveryRobot, MotionBoundsAreNeverExceededAndNotIdle)
{
    VectorXd lengths, bends, turns;
    std::vector<Vector3d> before, after, spins, later;
    double fullestWay = 0.0, fullestBend = 0.0, fullestTurn = 0.0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const VectorXd q = randomVector(arm_.dimension(), 3.0, generator_);
        // Now and then a single joint: there the bounds are met.
        VectorXd delta = randomVector(arm_.dimension(), 1.0, generator_);
        if (trial % 3 == 0)
            delta = delta.cwiseProduct(VectorXd::Unit(arm_.dimension(), trial % arm_.dimension()));
        arm_.motionBounds(delta, lengths, bends, turns);
        constexpr double h = 1e-5;
        arm_.velocities(placeAt(q - h * delta), delta, before, spins);
        arm_.velocities(placeAt(q + h * delta), delta, after, later);
        const SpatialArm::Placement from = placeAt(q), to = placeAt(q + delta);
        for (int i = 0; i < arm_.linkCount(); ++i)
        {
            for (const int end : {2 * i, 2 * i + 1})
            {
                const double bend = (after[end] - before[end]).norm() / (2.0 * h);
                ASSERT_LE((to.points[end] - from.points[end]).norm(), lengths[i] + 1e-12);
                ASSERT_LE(before[end].norm(), lengths[i] + 1e-12);
                ASSERT_LE(bend, bends[i] + 1e-8);
                fullestWay = std::max(fullestWay, before[end].norm() / std::max(lengths[i], 1e-9));
                fullestBend = std::max(fullestBend, bend / std::max(bends[i], 1e-3));
            }
            ASSERT_LE(spins[i].norm(), turns[i] + 1e-12);
            ASSERT_LE((later[i] - spins[i]).norm() / (2.0 * h), 0.5 * turns[i] * turns[i] + 1e-8);
            fullestTurn = std::max(fullestTurn, spins[i].norm() / std::max(turns[i], 1e-9));
        }
    }
    EXPECT_GT(fullestWay, 0.99);
    EXPECT_GT(fullestBend, 0.99);
    EXPECT_GT(fullestTurn, 0.99);
}

TEST_P(EveryRobot, ReachIsNeverExceeded)
{
    double farthest = 0.0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        VectorXd q = randomVector(arm_.dimension(), pi, generator_);
        for (int i = 0; i < arm_.dimension(); ++i)
            if (const auto &limits = arm_.joints()[i].limits)
                q[i] = std::clamp(q[i], limits->lower, limits->upper);
        const SpatialArm::Placement placement = placeAt(q);
        const Vector3d first = arm_.joints()[0].offset.translation();
        for (int i = 0; i < arm_.linkCount(); ++i)
            if (arm_.links()[i].joint >= 0)
                farthest = std::max(farthest, (placement.points[2 * i + 1] - first).norm() + arm_.links()[i].radius);
    }
    EXPECT_LE(farthest, arm_.reach());
    EXPECT_GT(farthest, 0.5 * arm_.reach());
}

INSTANTIATE_TEST_SUITE_P(SpatialArm, EveryRobot, testing::Range(0, 3));

TEST(SpatialArm, UniversalChainBendsByPitchThenYaw)
{
    const SpatialArm arm = universalChain({1.0, 0.0, 0.0}, {2.0, 1.0}, 0.1, std::nullopt, 0.7);
    ASSERT_EQ(arm.dimension(), 4);
    VectorXd q(4);
    q << 0.0, 0.0, 0.4, -0.5;
    SpatialArm::Placement placement;
    arm.place(q, placement);
    EXPECT_TRUE(placement.points[2].isApprox(Vector3d(3.0, 0.0, 0.0)));
    const Vector3d tip = placement.points[3] - placement.points[2];
    EXPECT_TRUE(tip.isApprox(Vector3d(std::cos(0.4) * std::cos(0.5), -std::sin(0.5), -std::sin(0.4) * std::cos(0.5))));
    ASSERT_EQ(arm.universalLimits().size(), 2u);
    EXPECT_EQ(arm.universalLimits()[1].first, 2);
    EXPECT_EQ(arm.universalLimits()[1].second, 3);
    EXPECT_DOUBLE_EQ(arm.joints()[3].limits->upper, 0.7);
}

TEST(SpatialArm, SlideMovesTheWholeChain)
{
    const SpatialArm arm = snake();
    SpatialArm::Placement rest, moved;
    VectorXd q = VectorXd::Zero(arm.dimension());
    arm.place(q, rest);
    q[0] = 0.5;
    arm.place(q, moved);
    for (std::size_t i = 0; i < rest.points.size(); ++i)
        EXPECT_TRUE((moved.points[i] - rest.points[i]).isApprox(Vector3d(0.3, 0.4, 0.0)));
}

TEST(SpatialArm, DenavitHartenbergRowsMultiplyAsPrinted)
{
    const SpatialArm arm = sixAxisArm();
    ASSERT_EQ(arm.linkCount(), 6);  // d1 a1 a2 a3 d4 d6
    const double right = std::acos(0.0);
    const double rows[6][4] = {{0.0, 0.45, 0.15, right}, {right, 0.0, 0.6, 0.0}, {0.0, 0.0, 0.12, right},
                               {0.0, 0.62, 0.0, -right}, {0.0, 0.0, 0.0, right}, {0.0, 0.1, 0.0, 0.0}};
    std::mt19937 generator(3);
    const VectorXd q = randomVector(6, 2.0, generator);
    Isometry3d tool = arm.joints()[0].offset;
    for (int i = 0; i < 6; ++i)
        tool = tool * Eigen::AngleAxisd(q[i] + rows[i][0], Vector3d::UnitZ()) *
               Eigen::Translation3d(rows[i][2], 0.0, rows[i][1]) * Eigen::AngleAxisd(rows[i][3], Vector3d::UnitX());
    SpatialArm::Placement placement;
    arm.place(q, placement);
    EXPECT_LT((placement.points[11] - tool.translation()).norm(), 1e-14);
}

TEST(SpatialArm, LinksThatMeetAtAJointAreNeighbours)
{
    const SpatialArm chain = snake();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_EQ(chain.areNeighbours(i, j), std::abs(i - j) <= 1) << i << " " << j;

    const SpatialArm arm = sixAxisArm();   // d1 a1 a2 a3 d4 d6
    EXPECT_TRUE(arm.areNeighbours(0, 1));  // one body
    EXPECT_FALSE(arm.areNeighbours(0, 2));
    EXPECT_TRUE(arm.areNeighbours(3, 4));
    EXPECT_TRUE(arm.areNeighbours(4, 5));  // two joints between them, both through the wrist's center

    const SpatialArm hand = gantryHand();
    EXPECT_TRUE(hand.areNeighbours(1, 2));   // the fingers' common joint
    EXPECT_TRUE(hand.areNeighbours(2, 3));   // one body
    EXPECT_FALSE(hand.areNeighbours(0, 3));  // the palm and the ball at a finger's tip
    EXPECT_FALSE(hand.areNeighbours(0, 4));  // slides between them
}

TEST(SpatialArm, ThickLinksNextToTheirJointAreNeighboursThinOnesAreNot)
{
    const auto beside = [](double radius)
    {
        return SpatialArm(
            {{Kind::Revolute, -1, Isometry3d::Identity(), Vector3d::UnitZ(), std::nullopt}},
            {{-1, {-1.0, 0.0, 0.0}, {-0.1, 0.0, 0.5}, radius}, {0, {0.1, 0.0, 0.4}, {1.0, 0.0, 0.0}, radius}});
    };
    EXPECT_TRUE(beside(0.2).areNeighbours(0, 1));
    EXPECT_FALSE(beside(0.05).areNeighbours(0, 1));
}

SpatialArm withJoint(const SpatialJoint &joint)
{
    return SpatialArm({{Kind::Revolute, -1, Isometry3d::Identity(), Vector3d::UnitZ(), std::nullopt}, joint},
                      {{1, Vector3d::Zero(), Vector3d::UnitX(), 0.0}});
}

TEST(SpatialArm, RefusesWhatIsNoRobot)
{
    const Isometry3d rest = Isometry3d::Identity();
    const Vector3d z = Vector3d::UnitZ();
    Isometry3d scaled = rest;
    scaled.linear() *= 1.1;
    EXPECT_THROW(withJoint({Kind::Revolute, 1, rest, z, std::nullopt}), std::invalid_argument);
    EXPECT_THROW(withJoint({Kind::Revolute, 0, scaled, z, std::nullopt}), std::invalid_argument);
    EXPECT_THROW(withJoint({Kind::Revolute, 0, rest, 2.0 * z, std::nullopt}), std::invalid_argument);
    EXPECT_THROW(withJoint({Kind::Revolute, 0, rest, z, Interval{1.0, 1.0}}), std::invalid_argument);
    EXPECT_THROW(withJoint({Kind::Prismatic, -1, rest, z, std::nullopt}), std::invalid_argument);
    EXPECT_THROW(withJoint({Kind::Prismatic, 0, rest, z, Interval{0.0, 1.0}}), std::invalid_argument);
    EXPECT_NO_THROW(withJoint({Kind::Prismatic, -1, rest, z, Interval{0.0, 1.0}}));
    EXPECT_THROW(universalChain(Vector3d::Zero(), {1.0, 0.0}, 0.0), std::invalid_argument);
    EXPECT_THROW(universalChain(Vector3d::Zero(), {1.0}, -0.1), std::invalid_argument);
    EXPECT_THROW(universalChain(Vector3d::Zero(), {1.0}, 0.1, std::nullopt, 1.6), std::invalid_argument);
    EXPECT_THROW(denavitHartenbergArm(rest, {}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
