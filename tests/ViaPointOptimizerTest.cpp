// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ViaPointOptimizer.h"

#include <gtest/gtest.h>

#include "ViaPointPaper.h"

namespace narrows
{
namespace
{
TrajectoryWish gentle(double maxOvershoot)
{
    TrajectoryWish wish;
    wish.maxOvershoot = maxOvershoot;
    return wish;
}

/// What the motion promises whatever the parameters, judged apart from the
/// optimizer.
void expectSound(const ViaPointTask &task, const OptimizedTrajectory &found)
{
    const ViaPointTask &timed = found.motion.task();
    EXPECT_NEAR(timed.viaTime / timed.duration, task.viaTime / task.duration, 1e-12);
    EXPECT_NEAR(found.motion.at<0>(timed.viaTime)[0], task.via, 1e-9);
    EXPECT_NEAR(found.motion.at<0>(timed.duration)[0], task.goal, 1e-9);
    for (const double end : {0.0, timed.duration})
    {
        EXPECT_NEAR(found.motion.at<3>(end)[1], 0.0, 1e-9);
        EXPECT_NEAR(found.motion.at<3>(end)[2], 0.0, 1e-7);
    }
}

TEST(ViaPointOptimizer, FindsTheLeastJerkOfTheThreeProblems)
{
    const struct
    {
        ViaPointTask task;
        double jerk;
    } problems[] = {{paperTaskA, 120.3}, {paperTaskB, 9084.0}, {paperTaskC, 1702.4}};
    for (const auto &[task, jerk] : problems)
    {
        const OrFailure<OptimizedTrajectory> found = optimizeViaPoint(task, gentle(0.4));
        ASSERT_TRUE(found) << toText(found.failure);
        EXPECT_LE(found->peaks[3].magnitude(), jerk);
        EXPECT_LE(ViaPointTrajectory::overshoot(task, found->peaks), 0.4);
        expectSound(task, *found);
    }
}

TEST(ViaPointOptimizer, MixedRisesNeedLessJerkForTheFirstProblem)
{
    TrajectoryWish wish = gentle(0.4);
    wish.mixed = true;
    const OrFailure<OptimizedTrajectory> found = optimizeViaPoint(paperTaskA, wish);
    ASSERT_TRUE(found);
    EXPECT_LE(found->peaks[3].magnitude(), 110.3);
    EXPECT_LE(ViaPointTrajectory::overshoot(paperTaskA, found->peaks), 0.4);
    expectSound(paperTaskA, *found);
}

TEST(ViaPointOptimizer, NoGridOfShapesIsBetter)
{
    const OrFailure<OptimizedTrajectory> found = optimizeViaPoint(paperTaskA, gentle(0.4));
    ASSERT_TRUE(found);
    for (double first = -2.0; first < 3.5; first += 0.25)
        for (double second = -2.0; second < first; second += 0.25)
        {
            const auto motion = ViaPointTrajectory::full(paperTaskA, std::exp(first), std::exp(second));
            if (!motion)
                continue;  // both rises hardly begin before the via
            const MotionPeaks peaks = motionPeaks(*motion, 1e-4);
            if (ViaPointTrajectory::overshoot(paperTaskA, peaks) <= 0.4)
            {
                EXPECT_GT(peaks[3].magnitude(), 0.999 * found->peaks[3].magnitude());
            }
        }
}

TEST(ViaPointOptimizer, EveryObjectiveIsBestAtItsOwn)
{
    TrajectoryWish wish;
    const OrFailure<OptimizedTrajectory> jerk = optimizeViaPoint(paperTaskC, wish);
    wish.objective = TrajectoryObjective::Acceleration;
    const OrFailure<OptimizedTrajectory> acceleration = optimizeViaPoint(paperTaskC, wish);
    wish.objective = TrajectoryObjective::Overshoot;
    const OrFailure<OptimizedTrajectory> overshoot = optimizeViaPoint(paperTaskC, wish);
    ASSERT_TRUE(jerk && acceleration && overshoot);
    EXPECT_LT(jerk->peaks[3].magnitude(), overshoot->peaks[3].magnitude());
    EXPECT_LE(jerk->peaks[3].magnitude(), acceleration->peaks[3].magnitude());
    EXPECT_LE(acceleration->peaks[2].magnitude(), jerk->peaks[2].magnitude());
    EXPECT_LT(ViaPointTrajectory::overshoot(paperTaskC, overshoot->peaks),
              ViaPointTrajectory::overshoot(paperTaskC, jerk->peaks));
}

TEST(ViaPointOptimizer, DurationIsTheLeastThatKeepsTheLimits)
{
    TrajectoryWish wish = gentle(0.4);
    wish.objective = TrajectoryObjective::Duration;
    wish.limits = MotionLimits{100.0, 400.0, 2000.0};
    const OrFailure<OptimizedTrajectory> found = optimizeViaPoint(paperTaskC, wish);
    ASSERT_TRUE(found);
    expectSound(paperTaskC, *found);
    EXPECT_LE(stretchFor(found->peaks, *wish.limits), 1.0);
    EXPECT_GT(stretchFor(found->peaks, *wish.limits), 1.0 - 1e-7);
    EXPECT_LE(ViaPointTrajectory::overshoot(paperTaskC, found->peaks), 0.4);
    // In the time that the fastest one needs no other objective keeps the limits
    // better.
    const OrFailure<OptimizedTrajectory> gentlest = optimizeViaPoint(paperTaskC, gentle(0.4));
    ASSERT_TRUE(gentlest);
    EXPECT_LE(found->motion.task().duration, 1.0001 * 3.0 * stretchFor(gentlest->peaks, *wish.limits));
}

TEST(ViaPointOptimizer, RefusesByName)
{
    TrajectoryWish wish;
    wish.objective = TrajectoryObjective::Duration;
    EXPECT_EQ(optimizeViaPoint(paperTaskA, wish).failure, TrajectoryFailure::BadLimit);
    for (const double bad : {0.0, -1.0, double(INFINITY), double(NAN)})
    {
        wish.limits = MotionLimits{1.0, bad, 1.0};
        EXPECT_EQ(optimizeViaPoint(paperTaskA, wish).failure, TrajectoryFailure::BadLimit);
    }
    EXPECT_EQ(optimizeViaPoint(paperTaskA, gentle(-1.0)).failure, TrajectoryFailure::BadLimit);
    EXPECT_EQ(optimizeViaPoint(paperTaskA, gentle(NAN)).failure, TrajectoryFailure::BadLimit);
    EXPECT_EQ(optimizeViaPoint({0.0, 1.0, 2.0, 3.0, 3.0}, {}).failure, TrajectoryFailure::BadTime);
    EXPECT_EQ(optimizeViaPoint({0.0, NAN, 2.0, 1.0, 3.0}, {}).failure, TrajectoryFailure::NotFinite);
    wish = {};
    wish.evaluations = 0;
    EXPECT_EQ(optimizeViaPoint(paperTaskA, wish).failure, TrajectoryFailure::BadCount);
    // 42 degrees in 3 s need 14 degrees per second on the average.
    wish = {};
    wish.limits = MotionLimits{13.0, 1e6, 1e6};
    EXPECT_EQ(optimizeViaPoint(paperTaskA, wish).failure, TrajectoryFailure::Infeasible);
}

TEST(ViaPointOptimizer, StandingStillIsOptimal)
{
    TrajectoryWish wish = gentle(0.0);
    wish.limits = MotionLimits{1.0, 1.0, 1.0};
    for (const TrajectoryObjective objective : {TrajectoryObjective::Jerk, TrajectoryObjective::Duration})
    {
        wish.objective = objective;
        const OrFailure<OptimizedTrajectory> found = optimizeViaPoint({5.0, 5.0, 5.0, 1.0, 2.0}, wish);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->peaks[3].magnitude(), 0.0);
    }
}
}  // namespace
}  // namespace narrows
