// SPDX-License-Identifier: BSD-3-Clause
// Inverse kinematics by iteration, the posture it prefers, and what is measured of the paths.
#include <gtest/gtest.h>

#include "HyperRedundantArm.h"
#include "SpatialRobots.h"
#include "kernel/DampedTipSearch.h"
#include "kernel/PathMeasures.h"
#include "kernel/PostureWish.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr unsigned int seed = 14;

bool unlimited(VectorXd &)
{
    return false;
}

Vector3d tipOf(const SpatialArm &arm, ConfigurationRef q, int link)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement.points[2 * link + 1];
}

TEST(DampedTipSearch, FollowsTheTipOfAnyArm)
{
    std::mt19937 generator(seed);
    for (const SpatialArm &arm : {snake(), sixAxisArm(), gantryHand()})
    {
        const int link = arm.linkCount() > 4 ? 2 : arm.linkCount() - 1;  // the gantry's last link does not move
        DampedTipSearch search(arm, {link, 1e-6, 50, unlimited}, {});
        for (int i = 0; i < 50; ++i)
        {
            VectorXd q = randomVector(arm.dimension(), 0.6, generator);
            const Vector3d target = tipOf(arm, q + randomVector(arm.dimension(), 0.01, generator), link);
            const TipSearchResult result = search.reach(target, q);
            ASSERT_EQ(result.status, TipSearchStatus::Reached);
            EXPECT_LT((tipOf(arm, q, link) - target).norm(), 1e-6);
        }
    }
}

TEST(DampedTipSearch, TakesOnePlacementWhereTheTipIsAlready)
{
    const SpatialArm arm = hyperRedundantArm();
    DampedTipSearch search(arm, {7, 1e-3, 50, unlimited}, {});
    VectorXd q = VectorXd::Zero(17);
    const TipSearchResult result = search.reach({3126.0, 0.0, 0.0}, q);
    EXPECT_EQ(result.status, TipSearchStatus::Reached);
    EXPECT_EQ(result.iterations, 1);
    EXPECT_EQ(q, VectorXd::Zero(17));
}

TEST(DampedTipSearch, NamesALimitInTheWay)
{
    const SpatialArm arm = hyperRedundantArm();
    const auto holdSlide = [](VectorXd &q)
    {
        const bool outside = q[0] != 0.0;
        q[0] = 0.0;
        return outside;
    };
    DampedTipSearch search(arm, {7, 1e-3, 20, holdSlide}, {});
    VectorXd q = VectorXd::Zero(17);
    TipSearchResult result = search.reach({3200.0, 0.0, 0.0}, q);
    EXPECT_EQ(result.status, TipSearchStatus::AtLimit);
    EXPECT_EQ(result.iterations, 20);
    EXPECT_EQ(q[0], 0.0);
    DampedTipSearch free(arm, {7, 1e-3, 20, unlimited}, {});
    result = free.reach({0.0, 9e5, 0.0}, q);
    EXPECT_EQ(result.status, TipSearchStatus::NoConvergence);
    EXPECT_TRUE(q.allFinite());
}

TEST(DampedTipSearch, LeavesTheTipWhereItIsInTheNullSpace)
{
    const SpatialArm arm = hyperRedundantArm();
    DampedTipSearchOptions options;
    options.nullSteps = 5;
    options.nullMotion = [](ConfigurationRef, const SpatialArm::Placement &, VectorXd &motion)
    {
        motion = VectorXd::Zero(17);
        motion[3] = 0.02;
    };
    DampedTipSearch search(arm, {7, 1e-6, 50, unlimited}, options);
    std::mt19937 generator(seed);
    const VectorXd start = randomVector(17, 0.2, generator);
    VectorXd q = start;
    const TipSearchResult result = search.reach(tipOf(arm, start, 7), q);
    ASSERT_EQ(result.status, TipSearchStatus::Reached);
    EXPECT_GT(result.iterations, 5);
    EXPECT_GT((q - start).tail(16).norm(), 0.05);
    EXPECT_LT((tipOf(arm, q, 7) - tipOf(arm, start, 7)).norm(), 1e-6);
}

TEST(DampedTipSearch, TakesFromANullMotionWhatMovesTheTip)
{
    const SpatialArm arm = hyperRedundantArm();
    const auto pitchTheSecond = [](ConfigurationRef, const SpatialArm::Placement &, VectorXd &motion)
    {
        motion = 1e-3 * VectorXd::Unit(17, 3);
    };
    DampedTipSearchOptions options;
    options.lambda = 1e-6;
    options.nullMotion = pitchTheSecond;
    DampedTipSearch search(arm, {7, 1e-9, 1, unlimited}, options);
    std::mt19937 generator(seed);
    const VectorXd start = randomVector(17, 0.2, generator);
    VectorXd q = start;
    search.reach(tipOf(arm, start, 7), q);
    EXPECT_GT((q - start).tail(16).norm(), 5e-4);
    EXPECT_GT((tipOf(arm, start + 1e-3 * VectorXd::Unit(17, 3), 7) - tipOf(arm, start, 7)).norm(), 1.0);
    EXPECT_LT((tipOf(arm, q, 7) - tipOf(arm, start, 7)).norm(), 5e-3);  // to first order nothing is left
}

VectorXd wishOf(const SpatialModel &model, const PostureWishOptions &options, const VectorXd &q)
{
    PostureWish wish(std::make_shared<const SpatialPoles>(model), options);
    SpatialArm::Placement placement;
    model.arm.place(q, placement);
    VectorXd motion;
    wish(q, placement, motion);
    return motion;
}

TEST(PostureWish, UnbendsUniversalJointsByItsShare)
{
    const SpatialModel model{snake(), {}};
    VectorXd q = VectorXd::Zero(9);
    q << 1.5, 1e-4, 0.0, 0.0, -2e-4, 0.3, 0.4, 0.0, 0.0;
    const VectorXd motion = wishOf(model, {0.25, 0.0, 0.0}, q);
    EXPECT_EQ(motion[0], 0.0);  // the slide
    EXPECT_NEAR(motion[1], -0.25e-4, 1e-12);
    EXPECT_NEAR(motion[4], 0.5e-4, 1e-12);
    EXPECT_LT(bendAngle(q[5] + motion[5], q[6] + motion[6]), bendAngle(0.3, 0.4));
}

TEST(PostureWish, TakesOtherJointsTowardsTheMiddleOfTheirLimits)
{
    const SpatialModel model{sixAxisArm(), {}};
    VectorXd q = VectorXd::Constant(6, 0.5);
    const VectorXd motion = wishOf(model, {1.0, 0.0, 0.0}, q);
    EXPECT_LT(motion.lpNorm<Eigen::Infinity>(), 0.5 + 1e-12);
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(q[i] + motion[i], 0.0, 1e-12) << i;  // all limits are symmetric, or there are none
}

double clearanceAt(const SpatialModel &model, const VectorXd &q, int link)
{
    SpatialArm::Placement placement;
    model.arm.place(q, placement);
    return SpatialPoles(model)
        .obstacles()[0]
        .clearance(placement.points[2 * link], placement.points[2 * link + 1], model.arm.links()[link].radius)
        .value;
}

TEST(PostureWish, WinsItsShareOfTheMissingClearance)
{
    // Only the last link is near.
    const SpatialModel model{hyperRedundantArm(), {{"ball", Sphere{{3000.0, 170.0, 0.0}, 100.0}}}};
    const VectorXd q = VectorXd::Zero(17);
    ASSERT_NEAR(clearanceAt(model, q, 7), 8.5, 1e-9);
    const VectorXd motion = wishOf(model, {0.0, 0.5, 10.5}, q);
    EXPECT_NEAR(clearanceAt(model, q + motion, 7), 9.5, 0.01);
    EXPECT_EQ(wishOf(model, {0.0, 0.5, 8.0}, q), VectorXd::Zero(17)) << "near enough to nothing";
}

TEST(PostureWish, AddsUpWhatAllLinksAskFor)
{
    const SpatialObstacle first{"first", Sphere{{250.0, 170.0, 0.0}, 100.0}};
    const SpatialObstacle last{"last", Sphere{{3000.0, 0.0, -170.0}, 100.0}};
    const PostureWishOptions options{0.0, 0.5, 20.0};
    const VectorXd q = VectorXd::Zero(17);
    const VectorXd one = wishOf({hyperRedundantArm(), {first}}, options, q);
    const VectorXd other = wishOf({hyperRedundantArm(), {last}}, options, q);
    EXPECT_GT(one.norm(), 1e-4);
    EXPECT_GT(other.norm(), 1e-4);
    EXPECT_LT((wishOf({hyperRedundantArm(), {first, last}}, options, q) - one - other).norm(), 1e-15);
}

TEST(PostureWish, DoesNotMindLinksThatAreNearEachOther)
{
    SpatialModel model{hyperRedundantArm(), {}, true};
    ASSERT_FALSE(SpatialPoles(model).pairs().empty());
    std::mt19937 generator(seed);
    const VectorXd q = randomVector(17, 0.3, generator);
    EXPECT_EQ(wishOf(model, {0.0, 0.5, 500.0}, q), VectorXd::Zero(17));
}

/// A path of the tip of one link that turns about z: a circle.
class CirclePath : public testing::Test
{
protected:
    SpatialArm arm_ = universalChain({0.0, 0.0, 0.0}, {2.0}, 0.0, std::nullopt, 1.4);
    static VectorXd at(double yaw) { return Eigen::Vector2d(0.0, yaw); }
    static Vector3d place(double yaw) { return 2.0 * Vector3d(std::cos(yaw), std::sin(yaw), 0.0); }
};

TEST_F(CirclePath, IsMeasured)
{
    const SpatialTask task{at(0.0), SpatialTipPath{0, {place(0.4), place(0.0)}, 1e-6}};
    const PathMeasures measures = measurePath(arm_, task, {at(0.0), at(0.4), at(0.0)});
    EXPECT_NEAR(measures.largestBend.value(), 0.4, 1e-15);
    EXPECT_EQ(measures.movedJoints, 1);
    EXPECT_NEAR(measures.tipLength, 2.0 * 4.0 * std::sin(0.2), 1e-14);
    EXPECT_NEAR(measures.tipDeviation.value(), 2.0 * (1.0 - std::cos(0.2)), 1e-14);  // in the middle of a motion
    EXPECT_EQ(measures.closure.value(), 0.0);
}

TEST_F(CirclePath, MayBeginAtItsFirstPoint)
{
    const SpatialTask task{at(0.0), SpatialTipPath{0, {place(0.0), place(0.4)}, 1e-6}};
    const PathMeasures measures = measurePath(arm_, task, {at(0.0), at(0.4)});
    EXPECT_NEAR(measures.tipDeviation.value(), 2.0 * (1.0 - std::cos(0.2)), 1e-14);
}

TEST_F(CirclePath, ThatTakesTheWrongTurnDeviates)
{
    // To the other side first: the leg to the first point is not over before that is reached.
    const SpatialTask task{at(0.0), SpatialTipPath{0, {place(0.4), place(0.2)}, 1e-6}};
    const PathMeasures measures = measurePath(arm_, task, {at(0.0), at(-0.3), at(0.4), at(0.2)});
    EXPECT_NEAR(measures.tipDeviation.value(), (place(-0.3) - place(0.0)).norm(), 1e-14);
    EXPECT_FALSE(measures.closure) << "the path is not closed";
    EXPECT_EQ(measures.movedJoints, 1);
}

TEST(PathMeasures, OfOtherTasksAndArms)
{
    const SpatialArm arm = sixAxisArm();
    VectorXd end = VectorXd::Zero(6);
    end[1] = 0.1;
    end[4] = 1e-9;  // has not moved
    const PathMeasures measures = measurePath(arm, {VectorXd::Zero(6), end}, {VectorXd::Zero(6), end});
    EXPECT_FALSE(measures.largestBend);
    EXPECT_EQ(measures.movedJoints, 1);
    EXPECT_GT(measures.tipLength, 0.05);
    EXPECT_FALSE(measures.tipDeviation);
    EXPECT_FALSE(measures.closure);
}

TEST(PathMeasures, TellAPostureThatDoesNotComeBack)
{
    const SpatialArm arm = snake();
    VectorXd end = VectorXd::Zero(9);
    end << 1.0, 0.0, 0.0, 0.0, 0.2, 0.0, -0.3, 0.0, 0.0;
    const SpatialTask task{VectorXd::Zero(9), SpatialTipPath{3, {tipOf(arm, VectorXd::Zero(9), 3)}, 5.0}};
    const PathMeasures measures = measurePath(arm, task, {VectorXd::Zero(9), end});
    EXPECT_EQ(measures.closure.value(), 0.3);  // the slide does not count
    EXPECT_EQ(measures.movedJoints, 2);
}
}  // namespace
}  // namespace narrows
