// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/StopAndGo.h"

#include <random>

#include <gtest/gtest.h>

#include "ViaPointPaper.h"
#include "kernel/trajectory/JerkLimitedMove.h"
#include "kernel/trajectory/TrajectoryPeaks.h"

namespace narrows
{
namespace
{
constexpr double many = 1e9;  // a limit that is never reached

TEST(JerkLimitedMove, HasTheKnownTimesWhereOneLimitBinds)
{
    // Jerk alone: 4 (d / 2j)^(1/3), so that a unit move in unit time takes a jerk of 32.
    EXPECT_NEAR(fastestMove(1.0, {many, many, 32.0}).duration(), 1.0, 1e-14);
    // Velocity alone: d / v. Acceleration alone: 2 sqrt(d / a).
    EXPECT_NEAR(fastestMove(3.0, {1.5, many, 1e30}).duration(), 2.0, 1e-8);
    EXPECT_NEAR(fastestMove(1.0, {many, 4.0, 1e30}).duration(), 1.0, 1e-12);
    // All: d / v + v / a + a / j.
    EXPECT_NEAR(fastestMove(10.0, {2.0, 3.0, 7.0}).duration(), 5.0 + 2.0 / 3.0 + 3.0 / 7.0, 1e-14);
    // Velocity and jerk: d / v + 2 sqrt(v / j).
    EXPECT_NEAR(fastestMove(10.0, {2.0, many, 8.0}).duration(), 6.0, 1e-14);
}

/// A fastest motion has, at every moment, a limit that it uses (bang-bang): that pins it, with its distance.
TEST(JerkLimitedMove, CoversTheDistanceAndAlwaysUsesALimit)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-3.0, 3.0);
    int cases[4] = {};
    for (int i = 0; i < 2000; ++i)
    {
        const double d = std::exp(exponent(random));
        const MotionLimits limits{std::exp(exponent(random)), std::exp(exponent(random)), std::exp(exponent(random))};
        const JerkLimitedMove move = fastestMove(d, limits);
        ASSERT_GE(std::min({move.jerkTime, move.steadyTime, move.cruiseTime}), 0.0);
        const double a = limits.jerk * move.jerkTime, half = 2.0 * move.jerkTime + move.steadyTime;
        const double v = a * (half - move.jerkTime);
        EXPECT_NEAR(v * (half + move.cruiseTime), d, 1e-12 * d);
        EXPECT_LE(a, limits.acceleration * (1.0 + 1e-12));
        EXPECT_LE(v, limits.velocity * (1.0 + 1e-12));
        EXPECT_NEAR(move.steadyTime > 0.0 ? a / limits.acceleration : 1.0, 1.0, 1e-12);
        EXPECT_NEAR(move.cruiseTime > 0.0 ? v / limits.velocity : 1.0, 1.0, 1e-12);
        ++cases[(move.steadyTime > 0.0 ? 1 : 0) + (move.cruiseTime > 0.0 ? 2 : 0)];
    }
    for (const int count : cases)
        EXPECT_GT(count, 50);
}

TEST(JerkLimitedMove, RefusesWhatIsNoLimit)
{
    for (const double bad : {0.0, -1.0, double(INFINITY), double(NAN)})
    {
        EXPECT_THROW(fastestMove(bad, {1.0, 1.0, 1.0}), std::invalid_argument);
        EXPECT_THROW(fastestMove(1.0, {1.0, bad, 1.0}), std::invalid_argument);
    }
}

Eigen::MatrixXd randomPoints(Eigen::Index joints, Eigen::Index count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    return Eigen::MatrixXd::NullaryExpr(joints, count, [&] { return angle(random); });
}

std::vector<MotionLimits> someLimits(Eigen::Index joints)
{
    std::vector<MotionLimits> limits;
    for (Eigen::Index i = 0; i < joints; ++i)
        limits.push_back({1.0 + 0.3 * static_cast<double>(i), 4.0 - 0.2 * static_cast<double>(i % 7), 20.0});
    return limits;
}

using MakeStops = OrFailure<PolynomialTrajectory> (*)(const Eigen::MatrixXd &, const std::vector<MotionLimits> &);
const MakeStops allStops[] = {sevenPhaseStops, quinticStops, trapezoidStops};

TEST(StopAndGo, StopsAtEveryVertexAndFollowsThePolyline)
{
    for (const MakeStops make : allStops)
        for (const Eigen::Index joints : {1, 7, 40})
        {
            const Eigen::MatrixXd points = randomPoints(joints, 6);
            const OrFailure<PolynomialTrajectory> motion = make(points, someLimits(joints));
            ASSERT_TRUE(motion);
            Eigen::Index reached = 0;
            JointTrajectory::States state;
            for (const double knot : motion->knots())
            {
                motion->at(knot, state);
                if ((state.col(0) - points.col(reached)).cwiseAbs().maxCoeff() > 1e-12)
                    continue;
                EXPECT_LT(state.col(1).cwiseAbs().maxCoeff(), 1e-9);
                ++reached;
                if (reached == points.cols())
                    break;
            }
            EXPECT_EQ(reached, points.cols());
            for (int i = 0; i <= 1000; ++i)
            {
                motion->at(motion->duration() * i / 1000.0, state);
                double nearest = INFINITY;
                for (Eigen::Index k = 1; k < points.cols(); ++k)
                {
                    const Eigen::VectorXd way = points.col(k) - points.col(k - 1),
                                          own = state.col(0) - points.col(k - 1);
                    const double share = std::clamp(own.dot(way) / way.squaredNorm(), 0.0, 1.0);
                    nearest = std::min(nearest, (own - share * way).cwiseAbs().maxCoeff());
                }
                EXPECT_LT(nearest, 1e-12);
            }
        }
}

TEST(StopAndGo, KeepsEveryJointsLimitsAndReachesOne)
{
    const std::vector<MotionLimits> limits = someLimits(7);
    for (const MakeStops make : allStops)
        for (Eigen::Index k = 0; k < 8; ++k)
        {
            const PolynomialTrajectory motion = *make(randomPoints(7, 9).middleCols(k, 2), limits);
            const std::vector<MotionPeaks> peaks = trajectoryPeaks(motion);
            const TimeStretch stretch = stretchFor(peaks, limits);
            EXPECT_NEAR(stretch.factor, 1.0, 1e-8);
            EXPECT_EQ(stretch.keepsAll, make != trapezoidStops);
            if (make != trapezoidStops)
                continue;
            for (const MotionPeaks &own : peaks)
                EXPECT_EQ(own[3].magnitude(), INFINITY);
        }
}

TEST(StopAndGo, SevenPhasesAreFasterThanTheQuinticStepAndSlowerThanTheTrapezoid)
{
    const Eigen::MatrixXd points = randomPoints(3, 12);
    const std::vector<MotionLimits> limits = someLimits(3);
    const double seven = sevenPhaseStops(points, limits)->duration();
    EXPECT_LT(trapezoidStops(points, limits)->duration(), seven);
    EXPECT_LT(seven, quinticStops(points, limits)->duration());
    EXPECT_NEAR(stopTimes(points, limits)->back(), seven, 1e-12 * seven);
}

TEST(StopAndGo, UnitMovesHaveTheKnownPeaks)
{
    const Eigen::MatrixXd unit = Eigen::RowVector2d(0.0, 1.0);
    const Series<3> quintic = largestPeaks(trajectoryPeaks(*quinticStops(unit, {{many, many, 60.0}})));
    EXPECT_NEAR(quintic[1], 1.875, 1e-9);
    EXPECT_NEAR(quintic[2], 10.0 / std::sqrt(3.0), 1e-8);
    EXPECT_NEAR(quintic[3], 60.0, 1e-9);
    const Series<3> bangBang = largestPeaks(trajectoryPeaks(*sevenPhaseStops(unit, {{many, many, 32.0}})));
    EXPECT_NEAR(bangBang[1], 2.0, 1e-9);
    EXPECT_NEAR(bangBang[2], 8.0, 1e-8);
    EXPECT_NEAR(bangBang[3], 32.0, 1e-9);
    const Series<3> blend = largestPeaks(trajectoryPeaks(*parabolicBlends(unit, {0.0, 1.0})));
    EXPECT_NEAR(blend[1], 1.5, 1e-9);
    EXPECT_NEAR(blend[2], 4.5, 1e-9);
    EXPECT_EQ(blend[3], INFINITY);
}

TEST(StopAndGo, ParabolicBlendsOfThePapersProblems)
{
    const struct
    {
        ViaPointTask task;
        double velocity, acceleration;
    } expected[] = {{paperTaskA, 25.0, 50.0}, {paperTaskB, 138.75, 1040.625}, {paperTaskC, 150.0, 300.0}};
    for (const auto &[task, velocity, acceleration] : expected)
    {
        const Series<3> peaks = largestPeaks(trajectoryPeaks(
            *parabolicBlends(Eigen::RowVector3d(task.start, task.via, task.goal), {0.0, task.viaTime, task.duration})));
        EXPECT_NEAR(peaks[1], velocity, 1e-8 * velocity);
        EXPECT_NEAR(peaks[2], acceleration, 1e-8 * acceleration);
    }
}

TEST(StopAndGo, PassesOverRepeatedVertices)
{
    Eigen::MatrixXd points(2, 6);
    points << 0.0, 0.0, 1.0, 1.0, 2.0, 2.0 + 1e-14,  //
        1.0, 1.0, 3.0, 3.0, 0.0, 0.0;
    const Eigen::MatrixXd distinct = distinctVertices(points);
    ASSERT_EQ(distinct.cols(), 3);
    EXPECT_EQ(distinct(0, 2), 2.0 + 1e-14);
    const std::vector<MotionLimits> limits = someLimits(2);
    EXPECT_EQ(sevenPhaseStops(points, limits)->duration(), sevenPhaseStops(distinct, limits)->duration());
}

TEST(StopAndGo, CornersAreWhereThePolylineBends)
{
    Eigen::MatrixXd points(2, 8);
    points << 0.0, 0.1, 0.3, 0.6, 0.6, 0.3, 0.3, 0.9,  //
        0.0, 0.1, 0.3, 0.6, 0.9, 0.9, 0.9, 0.9;
    const Eigen::MatrixXd corners = polylineCorners(points);
    Eigen::MatrixXd expected(2, 5);
    expected << 0.0, 0.6, 0.6, 0.3, 0.9,  // it turns back at 0.3
        0.0, 0.6, 0.9, 0.9, 0.9;
    ASSERT_EQ(corners.cols(), expected.cols());
    EXPECT_TRUE(corners == expected);
    EXPECT_EQ(polylineCorners(points.leftCols(1)).cols(), 1);
    EXPECT_EQ(polylineCorners(points.leftCols(0)).cols(), 0);
}

TEST(StopAndGo, RefusesByName)
{
    const Eigen::MatrixXd points = randomPoints(2, 3);
    const MotionLimits good{1.0, 1.0, 1.0};
    for (const MakeStops make : allStops)
    {
        EXPECT_EQ(make(points, {good}).failure, TrajectoryFailure::BadCount);
        EXPECT_EQ(make(points.leftCols(0), {good, good}).failure, TrajectoryFailure::BadCount);
        EXPECT_EQ(make(points.topRows(0), {}).failure, TrajectoryFailure::BadCount);
        EXPECT_EQ(make(points * NAN, {good, good}).failure, TrajectoryFailure::NotFinite);
        EXPECT_EQ(make(points.leftCols(1), {good, good}).failure, TrajectoryFailure::NoMotion);
        EXPECT_EQ(make(Eigen::MatrixXd::Ones(2, 4), {good, good}).failure, TrajectoryFailure::NoMotion);
        EXPECT_EQ(make(1e9 * points, {good, good}).failure, TrajectoryFailure::BadTime);
        for (const double bad : {0.0, -1.0, double(INFINITY), double(NAN)})
            EXPECT_EQ(make(points, {good, {1.0, bad, 1.0}}).failure, TrajectoryFailure::BadLimit);
    }
    EXPECT_EQ(parabolicBlends(points, {0.0, 2.0, 1.0}).failure, TrajectoryFailure::BadTime);
    EXPECT_THROW(parabolicBlends(Eigen::MatrixXd::Ones(2, 2), {0.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(stopTimes(Eigen::MatrixXd::Ones(2, 2), {good, good}), std::invalid_argument);
    EXPECT_EQ(stopTimes(points, {good}).failure, TrajectoryFailure::BadCount);
}
}  // namespace
}  // namespace narrows
