// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "SpatialScenes.h"
#include "kernel/threading/CentredStep.h"
#include "kernel/threading/SpatialMidGap.h"
#include "kernel/threading/SpatialOverlap.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double radius = 0.05;

Box wall(const Vector3d &lower, const Vector3d &upper)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = 0.5 * (lower + upper);
    return {pose, 0.5 * (upper - lower)};
}

/// Three links of universal joints; the last one can lie along x through an opening around (2, 0.5, 0.3).
struct Scene
{
    enum class Opening
    {
        Slot,
        Hole
    };

    Scene(Opening opening, double halfWidth)
      : model{universalChain(Vector3d::Zero(), {1.2, 1.2, 1.0}, radius), {}, true}
    {
        const double half = radius + halfWidth;
        model.obstacles = {{"below", wall({1.9, -2, -2}, {2.1, 3, 0.3 - half})},
                           {"above", wall({1.9, -2, 0.3 + half}, {2.1, 3, 2})}};
        if (opening == Opening::Hole)
        {
            model.obstacles.push_back({"right", wall({1.9, -2, 0.3 - half}, {2.1, 0.5 - half, 0.3 + half})});
            model.obstacles.push_back({"left", wall({1.9, 0.5 + half, 0.3 - half}, {2.1, 3, 0.3 + half})});
        }
        midGap = std::make_unique<SpatialMidGap>(model, 0.2);
    }

    /// The third link along x with its base at (x, y, 0.3); the elbow is low.
    VectorXd across(double x, double y = 0.5) const
    {
        const Vector3d end(x, y, 0.3), towards = end.normalized();
        const double along = 0.5 * end.norm();
        const Vector3d down = (-Vector3d::UnitZ() + towards.z() * towards).normalized();
        const Vector3d elbow = along * towards + std::sqrt(1.44 - along * along) * down;
        VectorXd q(6);
        Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
        int joint = 0;
        for (const Vector3d &direction :
             {elbow.normalized().eval(), (end - elbow).normalized().eval(), Vector3d(1, 0, 0)})
        {
            const Vector3d local = frame.transpose() * direction;
            const double pitch = std::atan2(-local.z(), local.x()), yaw = std::asin(local.y());
            q.segment<2>(joint) << pitch, yaw;
            joint += 2;
            frame = frame * Eigen::AngleAxisd(pitch, Vector3d::UnitY()) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
        }
        return q;
    }

    double clearance(const VectorXd &q) const
    {
        SpatialArm::Placement placement;
        model.arm.place(q, placement);
        double least = std::numeric_limits<double>::infinity();
        for (int link = 0; link < 3; ++link)
            for (const SpatialObstacle &obstacle : model.obstacles)
                least = std::min(least, nearnessOf(obstacle, placement.points[static_cast<std::size_t>(2 * link)],
                                                   placement.points[static_cast<std::size_t>(2 * link + 1)])
                                                .distance -
                                            radius);
        return least;
    }

    std::vector<GapCrossing> crossings(const VectorXd &q, double lengthening = 0.0) const
    {
        std::vector<GapCrossing> result;
        midGap->crossings(q, lengthening, result);
        return result;
    }

    VectorXd values(const VectorXd &q, const std::vector<GapCrossing> &which) const
    {
        VectorXd result;
        Eigen::MatrixXd unused;
        midGap->evaluate(q, which, result, unused);
        return result;
    }

    SpatialModel model;
    std::unique_ptr<SpatialMidGap> midGap;
};

TEST(SpatialMidGap, FindsTheLinkInTheOpening)
{
    const Scene hole(Scene::Opening::Hole, 1e-3);
    const VectorXd through = hole.across(1.5);
    ASSERT_NEAR(hole.clearance(through), 1e-3, 1e-12);
    const auto crossings = hole.crossings(through);
    ASSERT_EQ(crossings.size(), 2u);  // one gap across y, one across z
    EXPECT_EQ(crossings[0].link, 2);
    EXPECT_EQ(crossings[1].link, 2);
    EXPECT_NEAR(hole.midGap->halfWidth(through, crossings[0]), 1e-3, 1e-12);
    EXPECT_EQ(hole.midGap->size(crossings[0]), 0.25);  // of a link of length 1; the wall is 0.2 thick
    // Drawn back, the link ends 0.1 before the opening's middle.
    EXPECT_TRUE(hole.crossings(hole.across(0.9)).empty());
    EXPECT_TRUE(hole.crossings(hole.across(0.9), 0.1 / 0.25 - 1e-6).empty());
    EXPECT_EQ(hole.crossings(hole.across(0.9), 0.1 / 0.25 + 1e-6).size(), 2u);
}

TEST(SpatialMidGap, ASlotIsCrossedAnywhereAlongIt)
{
    const Scene slot(Scene::Opening::Slot, 1e-3);
    for (const double y : {0.5, -1.0, 1.5})
    {
        const auto crossings = slot.crossings(slot.across(1.5, y));
        ASSERT_EQ(crossings.size(), 1u) << y;
        EXPECT_LT(slot.values(slot.across(1.5, y), crossings).norm(), 1e-12);
    }
    // A hole is not.
    EXPECT_TRUE(Scene(Scene::Opening::Hole, 1e-3).crossings(slot.across(1.5, -1.0)).empty());
}

TEST(SpatialMidGap, EquationsAreDistanceAndTilt)
{
    const Scene hole(Scene::Opening::Hole, 1e-3);
    const auto crossings = hole.crossings(hole.across(1.5));
    EXPECT_LT(hole.values(hole.across(1.5), crossings).norm(), 1e-12);
    VectorXd turned = hole.across(1.5);
    turned[5] += 0.2;  // the last yaw, about an axis square to x, a base 0.5 before the middle
    SpatialArm::Placement placement;
    hole.model.arm.place(turned, placement);
    const Vector3d direction = placement.points[5] - placement.points[4];
    const VectorXd values = hole.values(turned, crossings);
    ASSERT_EQ(values.size(), 4);
    for (int i = 0; i < 2; ++i)
    {
        const Vector3d axis = hole.midGap->gaps()[static_cast<std::size_t>(i)].axis;
        EXPECT_NEAR(values[2 * i + 1], direction.dot(axis), 1e-12);
        // The line's distance, square to itself, from the middle: 0.5 before it, it is in the middle.
        const Vector3d across = axis - axis.dot(direction) * direction;
        EXPECT_NEAR(std::abs(values[2 * i]), 0.5 * std::abs(across.x()) / across.norm(), 1e-12);
    }
}

TEST(SpatialMidGap, DerivativeAgreesWithDifferences)
{
    std::mt19937 generator(7);
    for (const SpatialArm &arm : {snake(), sixAxisArm(), gantryHand()})
    {
        const int last = arm.linkCount() - 1;
        std::vector<SpatialGap> gaps(2, {{0.4, 0.3, 0.2}, Vector3d(1, 2, 2) / 3.0, Vector3d::Zero(), 0.0, 0.1, 0.2});
        gaps[1].along = Vector3d(2, 1, -2) / 3.0;
        gaps[1].halfLength = 0.5;
        const SpatialMidGap midGap(arm, gaps);
        const std::vector<GapCrossing> crossings{
            {0, 0, true}, {2, 1, true}, {last > 4 ? 2 : last, 0, false}, {1, 1, true}};
        for (int i = 0; i < 5; ++i)
        {
            const VectorXd q = randomVector(arm.dimension(), 0.5, generator);
            VectorXd values, plus, minus;
            Eigen::MatrixXd jacobian, unused;
            midGap.evaluate(q, crossings, values, jacobian);
            ASSERT_EQ(values.size(), 7);
            constexpr double step = 1e-6;
            for (int j = 0; j < arm.dimension(); ++j)
            {
                midGap.evaluate(q + step * VectorXd::Unit(q.size(), j), crossings, plus, unused);
                midGap.evaluate(q - step * VectorXd::Unit(q.size(), j), crossings, minus, unused);
                EXPECT_LT(((plus - minus) / (2.0 * step) - jacobian.row(j).transpose()).norm(), 1e-7) << "joint " << j;
            }
        }
    }
}

TEST(SpatialMidGap, FollowsTheAxisOfAHole)
{
    const Scene hole(Scene::Opening::Hole, 1e-4);
    CentredStep step(*hole.midGap);
    VectorXd q = hole.across(1.5), tangent, next;
    double x = 1.5;
    for (int i = 0; i < 8; ++i)
    {
        step.begin(q, hole.crossings(q));
        ASSERT_EQ(step.rank(), 4);
        step.tangent(hole.across(x - 0.05) - q, tangent);
        ASSERT_GT(tangent.norm(), 0.0);
        ASSERT_TRUE(step.reach(tangent, next));
        q = next;
        SpatialArm::Placement placement;
        hole.model.arm.place(q, placement);
        x = placement.points[4].x();
        // The base is on the axis, the link along it, and free.
        EXPECT_LT((placement.points[4].tail<2>() - Eigen::Vector2d(0.5, 0.3)).norm(), 1e-5);
        EXPECT_NEAR(hole.clearance(q), 1e-4, 2e-6);
    }
    EXPECT_LT(x, 1.2);
}

TEST(SpatialMidGap, ASlotLeavesTheLinkItsPlane)
{
    const Scene slot(Scene::Opening::Slot, 1e-4);
    CentredStep step(*slot.midGap);
    const VectorXd q = slot.across(1.5);
    step.begin(q, slot.crossings(q));
    EXPECT_EQ(step.rank(), 2);
    // Turned within the slot, by a rough guess, the link comes back into its plane.
    VectorXd offset = VectorXd::Zero(6), next;
    offset[1] = 0.2;
    ASSERT_TRUE(step.reach(offset, next));
    EXPECT_GT((next - q).norm(), 0.1);
    EXPECT_NEAR(slot.clearance(next), 1e-4, 2e-6);
}

TEST(SpatialMidGap, ThickLinksDoNotFit)
{
    const Scene hole(Scene::Opening::Hole, 1e-3);
    SpatialArm thick = universalChain(Vector3d::Zero(), {1.2, 1.2, 1.0}, radius + 2e-3);
    const SpatialMidGap midGap(thick, hole.midGap->gaps());
    std::vector<GapCrossing> result;
    midGap.crossings(hole.across(1.5), 0.0, result);
    EXPECT_TRUE(result.empty());
}

TEST(SpatialOverlap, IsTheLeastClearanceAndItsSlope)
{
    std::mt19937 generator(11);
    const Scene hole(Scene::Opening::Hole, 1e-2);
    SpatialModel model = hole.model;
    model.selfCollision = false;
    SpatialOverlap overlap(model);
    VectorXd gradient, unused;
    int overlapping = 0;
    for (int i = 0; i < 500; ++i)
    {
        const VectorXd q = randomVector(6, 1.5, generator);
        const double depth = overlap.deepest(q, gradient);
        EXPECT_NEAR(depth, std::min(0.0, hole.clearance(q)), 1e-12);
        // Deeper than its radius, a link has its middle line in a wall: where its deepest point is, there are kinks.
        if (!(depth < -1e-3 && depth > -0.99 * radius))
            continue;
        ++overlapping;
        constexpr double step = 1e-7;
        VectorXd differences(6);
        for (int j = 0; j < 6; ++j)
            differences[j] = (overlap.deepest(q + step * VectorXd::Unit(6, j), unused) -
                              overlap.deepest(q - step * VectorXd::Unit(6, j), unused)) /
                             (2.0 * step);
        EXPECT_LT((differences - gradient).norm(), 1e-5) << "draw " << i;
    }
    EXPECT_GT(overlapping, 10);
}

TEST(SpatialOverlap, KnowsLinksThatTouch)
{
    SpatialModel model{universalChain(Vector3d::Zero(), {1.0, 1.0, 1.0}, radius), {}, true};
    SpatialOverlap overlap(model);
    VectorXd gradient, folded(6);
    // All in one plane; the third link goes back across the first.
    folded << 0.0, 0.0, 0.0, 2.4, 0.0, 2.4;
    SpatialArm::Placement placement;
    model.arm.place(folded, placement);
    const ClosestFractions closest =
        closestFractions(placement.points[0], placement.points[1], placement.points[4], placement.points[5]);
    ASSERT_LT((placement.points[0] + closest.first * (placement.points[1] - placement.points[0]) - placement.points[4] -
               closest.second * (placement.points[5] - placement.points[4]))
                  .norm(),
              1e-9);
    EXPECT_NEAR(overlap.deepest(folded, gradient), -2.0 * radius, 1e-9);
    EXPECT_GT(gradient.norm(), 0.1);
    model.selfCollision = false;
    EXPECT_EQ(SpatialOverlap(model).deepest(folded, gradient), 0.0);
}
}  // namespace
}  // namespace narrows
