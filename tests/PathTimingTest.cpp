// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/PathTiming.h"

#include <gtest/gtest.h>

#include "RunSpecs.h"
#include "benchmark/RunOnce.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"

namespace narrows
{
namespace
{
constexpr MotionLimits limits{1.5, 4.0, 20.0};

RunSpec runOf(const std::string &planner, const std::string &scenario)
{
    RunSpec spec = smallRun(planner, 3);
    spec.scenario = std::make_shared<const Scenario>(
        readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + scenario + ".yaml"));
    return spec;
}

Record solve(const RunSpec &spec)
{
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Solved) << record.reason;
    return record;
}

Record following(const std::vector<Eigen::VectorXd> &path)
{
    Record record;
    record.outcome = Outcome::Solved;
    record.path = path;
    return record;
}

double timeWithAllStops(const std::vector<Eigen::VectorXd> &path)
{
    Eigen::MatrixXd points(path.front().size(), static_cast<Eigen::Index>(path.size()));
    for (std::size_t i = 0; i < path.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = path[i];
    return sevenPhaseStops(points, std::vector<MotionLimits>(path.front().size(), limits))->duration();
}

/// The motion as a polyline of configurations, a thousand a second.
std::vector<Eigen::VectorXd> sampled(const World &world, const JointTrajectory &motion)
{
    std::vector<Eigen::VectorXd> rows;
    JointTrajectory::States state;
    const int count = static_cast<int>(1000.0 * motion.duration());
    for (int i = 0; i <= count; ++i)
    {
        motion.at(motion.duration() * i / count, state);
        rows.push_back(fromFile(world, state.col(0)));
    }
    return rows;
}

void expectGood(const RunSpec &spec, const std::vector<Eigen::VectorXd> &path, const PathTiming &timing)
{
    for (const MotionPeaks &own : timing.peaks)
        EXPECT_LE(stretchFor(own, limits), 1.0 + 1e-8);
    EXPECT_LE(timing.motion->duration(), timing.stopDuration);
    const double farthest = (path.back() - path.front()).cwiseAbs().maxCoeff();
    EXPECT_GE(timing.motion->duration(), farthest / limits.velocity);
    JointTrajectory::States state;
    timing.motion->at(0.0, state);
    EXPECT_LT((state.col(0) - path.front()).cwiseAbs().maxCoeff(), 1e-12);
    timing.motion->at(timing.motion->duration(), state);
    EXPECT_LT((state.col(0) - path.back()).cwiseAbs().maxCoeff(), 1e-12);
    const Verdict verdict = verify(spec.scenario->world, sampled(spec.scenario->world, *timing.motion));
    EXPECT_TRUE(verdict.accepted) << verdict.reason << " in segment " << verdict.segment;
}

TEST(PathTiming, KeepsTheLimitsAndHitsNothing)
{
    for (const char *planner : {"rrtconnect", "bkpiece1"})
    {
        const RunSpec spec = runOf(planner, "gap_small");
        const Record record = solve(spec);
        const std::vector<Eigen::VectorXd> &path = record.path;
        const OrFailure<PathTiming> timing = timePath(spec, record, limits);
        ASSERT_TRUE(timing) << toText(timing.failure);
        expectGood(spec, path, *timing);
        EXPECT_LE(timing->stopDuration, timeWithAllStops(path));
        EXPECT_EQ(timePath(spec, record, limits)->motion->duration(), timing->motion->duration());
    }
}

TEST(PathTiming, APathOfManyWaypointsIsNotDrivenFromOneToTheNext)
{
    const RunSpec spec = runOf("hppm", "hppm_case1");
    const Record record = solve(spec);
    const std::vector<Eigen::VectorXd> &path = record.path;
    ASSERT_GT(path.size(), 20u);
    const OrFailure<PathTiming> timing = timePath(spec, record, limits);
    ASSERT_TRUE(timing) << toText(timing.failure);
    expectGood(spec, path, *timing);
    EXPECT_LT(timing->stopDuration, 0.5 * timeWithAllStops(path));
}

TEST(PathTiming, ASmoothPathIsAsFastAsThePolylineItWasMadeFrom)
{
    const RunSpec spec = runOf("viapoint", "arm_7link_1disc");
    const Record record = solve(spec);
    ASSERT_GT(record.vias.size(), 2u);
    ASSERT_GT(record.path.size(), record.vias.size());
    const OrFailure<PathTiming> timing = timePath(spec, record, limits);
    ASSERT_TRUE(timing) << toText(timing.failure);
    expectGood(spec, record.path, *timing);
    Record along = record;
    along.path.swap(along.vias);
    along.vias.clear();
    EXPECT_LE(timing->motion->duration(), timePath(spec, along, limits)->motion->duration() * (1.0 + 1e-9));
}

TEST(PathTiming, FullTurnsAreMotions)
{
    // Past pi, which a wrapping space would call the way back.
    const RunSpec spec = runOf("rrtconnect", "gap_small");
    Eigen::VectorXd from = spec.scenario->planar().task.start, to = from;
    to.array() += 4.0 * std::acos(0.0);
    const OrFailure<PathTiming> timing =
        timePath(spec, following({toFile(spec.scenario->world, from), toFile(spec.scenario->world, to)}), limits);
    ASSERT_TRUE(timing) << toText(timing.failure);
    EXPECT_GE(timing->motion->duration(), 4.0 * std::acos(0.0) / limits.velocity);
}

TEST(PathTiming, AlongATipPathNoCornerIsCut)
{
    const RunSpec spec = runOf("vdsm", "vdsm_none");
    const Record record = solve(spec);
    const std::vector<Eigen::VectorXd> &path = record.path;
    const OrFailure<PathTiming> timing = timePath(spec, record, limits);
    ASSERT_TRUE(timing) << toText(timing.failure);
    EXPECT_EQ(timing->method, "stop and go");
    EXPECT_EQ(timing->motion->duration(), timing->stopDuration);
    EXPECT_NEAR(timing->stopDuration, timeWithAllStops(path), 0.5 * timing->stopDuration);
}

TEST(PathTiming, WhatDoesNotMoveHasNoDuration)
{
    const RunSpec spec = runOf("rrtconnect", "gap_small");
    const Eigen::VectorXd rest = toFile(spec.scenario->world, spec.scenario->planar().task.start);
    EXPECT_EQ(timePath(spec, following({rest, rest}), limits).failure, TrajectoryFailure::NoMotion);
    EXPECT_EQ(timePath(spec, following({rest}), limits).failure, TrajectoryFailure::NoMotion);
    EXPECT_EQ(timePath(spec, following({}), limits).failure, TrajectoryFailure::BadCount);
}

TEST(PathTiming, LimitsAreThreePositiveNumbers)
{
    const MotionLimits read = limitsFromText(" 1.5, 4,2e1 ");
    EXPECT_EQ(read.velocity, 1.5);
    EXPECT_EQ(read.acceleration, 4.0);
    EXPECT_EQ(read.jerk, 20.0);
    for (const char *bad :
         {"", "1", "1,2", "1,2,3,4", "1,2,0", "1,-2,3", "1,2,inf", "nan,2,3", "1,,3", "1;2;3", "1,2,3m"})
        EXPECT_THROW(limitsFromText(bad), std::invalid_argument) << bad;
}
}  // namespace
}  // namespace narrows
