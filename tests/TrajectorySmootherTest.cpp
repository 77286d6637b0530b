// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TrajectorySmoother.h"

#include <random>

#include <gtest/gtest.h>

#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"

namespace narrows
{
namespace
{
std::vector<MotionLimits> limitsFor(Eigen::Index joints)
{
    return std::vector<MotionLimits>(static_cast<std::size_t>(joints), {1.5, 4.0, 20.0});
}

Eigen::MatrixXd randomVertices(Eigen::Index joints, Eigen::Index count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-2.0, 2.0);
    return Eigen::MatrixXd::NullaryExpr(joints, count, [&] { return angle(random); });
}

const TrajectoryProof everythingIsFree = [](const JointTrajectory &)
{
    return true;
};
const TrajectoryProof nothingIsFree = [](const JointTrajectory &)
{
    return false;
};

TEST(OverlappedMoves, WithoutOverlapsAreTheFastestStops)
{
    for (const Eigen::Index joints : {1, 3, 40})
    {
        const Eigen::MatrixXd vertices = randomVertices(joints, 6, 1);
        const auto moves = OverlappedMoves::along(vertices, limitsFor(joints));
        ASSERT_TRUE(moves);
        const PolynomialTrajectory motion = moves->motion(moves->stops());
        const PolynomialTrajectory stops = *sevenPhaseStops(vertices, limitsFor(joints)).value;
        EXPECT_NEAR(motion.duration(), stops.duration(), 1e-12 * stops.duration());
        EXPECT_NEAR(moves->stretchToLimits(motion), 1.0, 2e-9);
        JointTrajectory::States own, other;
        for (int i = 0; i <= 500; ++i)
        {
            const double t = stops.duration() * i / 500.0;
            motion.at(t, own);
            stops.at(t, other);
            EXPECT_LT((own - other).leftCols(3).cwiseAbs().maxCoeff(), 1e-9) << t;
        }
    }
}

TEST(OverlappedMoves, AreContinuousUpToTheAccelerationAndEndAtRest)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int trial = 0; trial < 50; ++trial)
    {
        const Eigen::Index joints = 1 + trial % 7, count = 2 + trial % 6;
        const Eigen::MatrixXd vertices = randomVertices(joints, count, static_cast<unsigned>(trial));
        const auto moves = OverlappedMoves::along(vertices, limitsFor(joints));
        ASSERT_TRUE(moves);
        MoveTiming timing = moves->stops();
        for (double &overlap : timing.overlaps)
            overlap = share(random);
        for (double &slowness : timing.slowness)
            slowness = 0.7 + share(random);
        const PolynomialTrajectory motion = moves->motion(timing);
        JointTrajectory::States state;
        motion.at(0.0, state);
        EXPECT_LT((state.col(0) - vertices.col(0)).norm(), 1e-12);
        motion.at(motion.duration(), state);
        EXPECT_LT((state.col(0) - vertices.rightCols(1)).norm(), 1e-12);
        for (Eigen::Index joint = 0; joint < joints; ++joint)
        {
            const Series<3> jumps = largestJumps(*motion.joint(joint));
            EXPECT_LT(std::max({jumps[0], jumps[1], jumps[2]}), 1e-9);
        }
    }
}

TEST(OverlappedMoves, KnowTheStretchThatCertifiedPeaksAskFor)
{
    for (unsigned seed = 0; seed < 20; ++seed)
    {
        const Eigen::MatrixXd vertices = randomVertices(4, 5, seed);
        const auto moves = OverlappedMoves::along(vertices, limitsFor(4));
        MoveTiming timing = moves->stops();
        timing.overlaps.setConstant(0.1 + 0.04 * seed);
        const PolynomialTrajectory motion = moves->motion(timing);
        const double exact = moves->stretchToLimits(motion);
        EXPECT_NEAR(stretchFor(trajectoryPeaks(motion), limitsFor(4)).factor / exact, 1.0, 5e-9);
    }
}

TEST(OverlappedMoves, MovesInOneDirectionBlendIntoOneMove)
{
    // A way of 2 as two moves whose ramps overlap entirely: velocity stays at its limit, so that the second begins
    // where the first begins to slow down.
    const std::vector<MotionLimits> limits{{1.0, 2.0, 10.0}};
    const auto moves = OverlappedMoves::along(Eigen::RowVector3d(0.0, 2.0, 4.0), limits);
    const JerkLimitedMove half = fastestMove(2.0, limits[0]), whole = fastestMove(4.0, limits[0]);
    const double ramp = 2.0 * half.jerkTime + half.steadyTime;
    MoveTiming timing = moves->stops();
    timing.overlaps[0] = ramp / half.duration();
    const PolynomialTrajectory motion = moves->motion(timing);
    EXPECT_NEAR(motion.duration(), whole.duration(), 1e-12);
    EXPECT_NEAR(moves->stretchToLimits(motion), 1.0, 2e-9);
}

TEST(TrajectorySmoother, KeepsLimitsAndIsShorterThanStops)
{
    for (const Eigen::Index joints : {1, 2, 7, 40})
    {
        const Eigen::MatrixXd vertices = randomVertices(joints, 5, 3);
        const auto smoothed = smoothTrajectory(vertices, limitsFor(joints), everythingIsFree);
        ASSERT_TRUE(smoothed);
        EXPECT_TRUE(smoothed->blended);
        const double stops = sevenPhaseStops(vertices, limitsFor(joints)).value->duration();
        EXPECT_NEAR(smoothed->stopDuration, stops, 1e-8 * stops);
        EXPECT_LT(smoothed->motion.duration(), 0.85 * stops) << joints;
        const TimeStretch stretch = stretchFor(trajectoryPeaks(smoothed->motion), limitsFor(joints));
        EXPECT_LE(stretch.factor, 1.0 + 2e-9);
        EXPECT_GE(stretch.factor, 1.0 - 1e-6);
        JointTrajectory::States state;
        smoothed->motion.at(0.0, state);
        EXPECT_LT((state.col(0) - vertices.col(0)).norm(), 1e-9);
        smoothed->motion.at(smoothed->motion.duration(), state);
        EXPECT_LT((state.col(0) - vertices.rightCols(1)).norm(), 1e-9);
        EXPECT_LT(state.middleCols(1, 2).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(TrajectorySmoother, OnlyReturnsWhatWasProven)
{
    const Eigen::MatrixXd vertices = randomVertices(3, 5, 5);
    const auto none = smoothTrajectory(vertices, limitsFor(3), nothingIsFree);
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->blended);
    EXPECT_EQ(none->motion.duration(), none->stopDuration);
    EXPECT_GT(none->proofs, 0);

    // Proven is what passes within 0.3 of the second vertex.
    const auto isNear = [&vertices](const JointTrajectory &motion)
    {
        JointTrajectory::States state;
        double least = 1e9;
        for (int i = 0; i <= 2000; ++i)
        {
            motion.at(motion.duration() * i / 2000.0, state);
            least = std::min(least, (state.col(0) - vertices.col(1)).norm());
        }
        return least < 0.3;
    };
    const auto some = smoothTrajectory(vertices, limitsFor(3), isNear);
    ASSERT_TRUE(some && some->blended);
    EXPECT_TRUE(isNear(some->motion));
    EXPECT_LT(some->motion.duration(), some->stopDuration);
    EXPECT_GT(some->motion.duration(), smoothTrajectory(vertices, limitsFor(3), everythingIsFree)->motion.duration());
}

TEST(TrajectorySmoother, OneSegmentIsTheFastestMove)
{
    const Eigen::MatrixXd vertices = randomVertices(3, 2, 6);
    const auto smoothed = smoothTrajectory(vertices, limitsFor(3), nothingIsFree);
    ASSERT_TRUE(smoothed);
    EXPECT_EQ(smoothed->proofs, 0);
    EXPECT_NEAR(smoothed->motion.duration(), sevenPhaseStops(vertices, limitsFor(3)).value->duration(), 1e-8);
}

TEST(TrajectorySmoother, IsDeterministicAndKeepsItsBudget)
{
    const Eigen::MatrixXd vertices = randomVertices(3, 6, 7);
    SmoothingOptions options;
    options.evaluations = 300;
    const auto first = smoothTrajectory(vertices, limitsFor(3), everythingIsFree, options);
    const auto second = smoothTrajectory(vertices, limitsFor(3), everythingIsFree, options);
    EXPECT_EQ(first->motion.duration(), second->motion.duration());
    EXPECT_EQ(first->evaluations, second->evaluations);
    options.evaluations = 0;
    const auto bisected = smoothTrajectory(vertices, limitsFor(3), everythingIsFree, options);
    EXPECT_LE(first->evaluations - bisected->evaluations, 301);
    EXPECT_LT(first->motion.duration(), bisected->motion.duration());
    options.interrupted = []
    {
        return true;
    };
    const auto interrupted = smoothTrajectory(vertices, limitsFor(3), everythingIsFree, options);
    EXPECT_EQ(interrupted->motion.duration(), interrupted->stopDuration);
}

TEST(TrajectorySmoother, RefusesByName)
{
    const Eigen::MatrixXd vertices = randomVertices(2, 4, 8);
    const auto failure = [](const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
    {
        return smoothTrajectory(points, limits, everythingIsFree).failure;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinity, std::nan("")})
    {
        EXPECT_EQ(failure(vertices, {{1.0, 1.0, 1.0}, {bad, 1.0, 1.0}}), TrajectoryFailure::BadLimit);
        EXPECT_EQ(failure(vertices, {{1.0, 1.0, 1.0}, {1.0, bad, 1.0}}), TrajectoryFailure::BadLimit);
        EXPECT_EQ(failure(vertices, {{1.0, 1.0, 1.0}, {1.0, 1.0, bad}}), TrajectoryFailure::BadLimit);
    }
    EXPECT_EQ(failure(vertices, limitsFor(3)), TrajectoryFailure::BadCount);
    EXPECT_EQ(failure(Eigen::MatrixXd::Ones(2, 4), limitsFor(2)), TrajectoryFailure::NoMotion);
    Eigen::MatrixXd broken = vertices;
    broken(1, 2) = infinity;
    EXPECT_EQ(failure(broken, limitsFor(2)), TrajectoryFailure::NotFinite);
    SmoothingOptions options;
    options.evaluations = -1;
    EXPECT_EQ(smoothTrajectory(vertices, limitsFor(2), everythingIsFree, options).failure, TrajectoryFailure::BadCount);
    // Vertices that repeat are one.
    Eigen::MatrixXd repeated(2, 5);
    repeated << vertices.col(0), vertices.col(0), vertices.col(1), vertices.col(2), vertices.col(3);
    EXPECT_EQ(smoothTrajectory(repeated, limitsFor(2), everythingIsFree)->motion.duration(),
              smoothTrajectory(vertices, limitsFor(2), everythingIsFree)->motion.duration());
}
}  // namespace
}  // namespace narrows
