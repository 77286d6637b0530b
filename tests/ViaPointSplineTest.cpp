// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/ViaPointSpline.h"

#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
std::vector<double> ramp(std::size_t count, double step = 1.0)
{
    std::vector<double> times(count);
    for (std::size_t i = 0; i < count; ++i)
        times[i] = step * static_cast<double>(i);
    return times;
}

Eigen::MatrixXd randomPoints(Eigen::Index joints, Eigen::Index count, unsigned seed = 3)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-3.0, 3.0);
    return Eigen::MatrixXd::NullaryExpr(joints, count, [&] { return angle(random); });
}

const Rise rises[] = {*Rise::resting(1.0), *Rise::symmetric(0.75), Rise::quintic()};

TEST(ViaPointSpline, PassesThroughAllPointsAndRestsAtBothEnds)
{
    for (const Rise &rise : rises)
        for (const Eigen::Index joints : {1, 7, 40})
            for (const std::size_t count : {2u, 3u, 5u, 41u})
                for (const double overlap : {0.0, 0.3, 0.7})
                {
                    const Eigen::MatrixXd points = randomPoints(joints, static_cast<Eigen::Index>(count));
                    const OrFailure<ViaPointSpline> spline =
                        ViaPointSpline::through(points, ramp(count, 0.5), overlap, rise);
                    ASSERT_TRUE(spline) << toText(spline.failure) << count << " " << overlap;
                    ViaPointSpline::State<3> state;
                    for (std::size_t i = 0; i < count; ++i)
                    {
                        spline->at<3>(spline->times()[i], state);
                        EXPECT_LT((state.col(0) - points.col(static_cast<Eigen::Index>(i))).cwiseAbs().maxCoeff(),
                                  1e-12);
                        if (i > 0 && i + 1 < count && overlap > 0.0)
                            continue;
                        EXPECT_LT(state.middleCols(1, 2).cwiseAbs().maxCoeff(), 1e-10);  // rest
                    }
                }
}

TEST(ViaPointSpline, WithoutOverlapItIsThePolyline)
{
    const Eigen::MatrixXd points = randomPoints(3, 6);
    const ViaPointSpline spline = *ViaPointSpline::through(points, ramp(6), 0.0, Rise::quintic());
    ViaPointSpline::State<0> state;
    for (double t = 0.01; t < 5.0; t += 0.01)
    {
        spline.at<0>(t, state);
        const Eigen::Index k = static_cast<Eigen::Index>(t);
        const double share = Rise::quintic().at<0>(t - static_cast<double>(k))[0];
        EXPECT_LT((state - (1.0 - share) * points.col(k) - share * points.col(k + 1)).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(ViaPointSpline, VelocityAndAccelerationAreContinuousEverywhere)
{
    const Eigen::MatrixXd points = randomPoints(2, 9);
    std::vector<double> times = ramp(9);
    for (std::size_t i = 1; i < times.size(); ++i)
        times[i] += 0.2 * std::sin(3.0 * static_cast<double>(i));
    for (const Rise &rise : rises)
    {
        const ViaPointSpline spline = *ViaPointSpline::through(points, times, 0.6, rise);
        ViaPointSpline::State<3> left, right;
        for (const double knot : spline.joint(0)->knots())
        {
            if (knot == 0.0 || knot == spline.duration())
                continue;
            spline.at<3>(knot - 1e-12, left);
            spline.at<3>(knot + 1e-12, right);
            EXPECT_LT((right - left).leftCols(3).cwiseAbs().maxCoeff(), 1e-8);
        }
    }
}

TEST(ViaPointSpline, DerivativesAreThoseOfThePosition)
{
    const ViaPointSpline spline = *ViaPointSpline::through(randomPoints(3, 7), ramp(7, 0.8), 0.5, *Rise::resting(0.8));
    const double h = 1e-4;
    ViaPointSpline::State<3> before, here, after;
    for (double t = 0.013; t < spline.duration(); t += 0.037)
    {
        spline.at<3>(t - h, before);
        spline.at<3>(t, here);
        spline.at<3>(t + h, after);
        const Eigen::MatrixXd difference = (after - before).leftCols(2) / (2.0 * h);
        EXPECT_LT((difference - here.middleCols(1, 2)).cwiseAbs().maxCoeff(), 1e-3);
    }
}

TEST(ViaPointSpline, PeaksHoldForEverySample)
{
    for (const Rise &rise : rises)
    {
        const ViaPointSpline spline = *ViaPointSpline::through(randomPoints(2, 6), ramp(6), 0.4, rise);
        for (Eigen::Index joint = 0; joint < 2; ++joint)
        {
            const MotionPeaks peaks = motionPeaks(*spline.joint(joint));
            Series<3> largest{};
            ViaPointSpline::State<3> state;
            for (int i = 0; i <= 20000; ++i)
            {
                spline.at<3>(spline.duration() * i / 20000.0, state);
                for (int k = 0; k < 4; ++k)
                    largest[k] = std::max(largest[k], std::abs(state(joint, k)));
            }
            for (int k = 0; k < 4; ++k)
            {
                EXPECT_LE(largest[k], peaks[k].magnitude() * (1.0 + 2e-9));
                EXPECT_GE(largest[k], peaks[k].magnitude() * (1.0 - 2e-2));
            }
        }
    }
}

TEST(ViaPointSpline, ScaledToItsLimitsItKeepsThemAndNeedsThem)
{
    const std::vector<MotionLimits> limits(3, {1.5, 4.0, 20.0});
    const ViaPointSpline spline = *ViaPointSpline::through(randomPoints(3, 5), ramp(5), 0.5, Rise::quintic());
    const OrFailure<ViaPointSpline> scaled = spline.scaledTo(limits);
    ASSERT_TRUE(scaled);
    double used = 0.0;
    for (Eigen::Index joint = 0; joint < 3; ++joint)
        used = std::max(used, stretchFor(motionPeaks(*scaled->joint(joint)), limits[0]));
    EXPECT_LE(used, 1.0);
    EXPECT_GT(used, 1.0 - 1e-8);
    EXPECT_TRUE(scaled->levels() == spline.levels());

    EXPECT_EQ(spline.scaledTo({limits[0]}).failure, TrajectoryFailure::BadCount);
    for (const double bad : {0.0, -1.0, double(INFINITY), double(NAN)})
        EXPECT_EQ(spline.scaledTo({limits[0], limits[0], {1.0, bad, 1.0}}).failure, TrajectoryFailure::BadLimit);
}

TEST(ViaPointSpline, RefusesByName)
{
    const auto failure = [](const Eigen::MatrixXd &points, const std::vector<double> &times, double overlap)
    {
        return ViaPointSpline::through(points, times, overlap, Rise::quintic()).failure;
    };
    const Eigen::MatrixXd points = randomPoints(2, 3);
    EXPECT_EQ(failure(points, {0.0, 1.0}, 0.5), TrajectoryFailure::BadCount);
    EXPECT_EQ(failure(points.leftCols(1), {0.0}, 0.5), TrajectoryFailure::BadCount);
    EXPECT_EQ(failure(points.topRows(0), {0.0, 1.0, 2.0}, 0.5), TrajectoryFailure::BadCount);
    EXPECT_EQ(failure(points, {0.0, 2.0, 1.0}, 0.5), TrajectoryFailure::BadTime);
    EXPECT_EQ(failure(points, {0.0, 1.0, 1.0}, 0.5), TrajectoryFailure::BadTime);
    EXPECT_EQ(failure(points, {1.0, 2.0, 3.0}, 0.5), TrajectoryFailure::BadTime);
    EXPECT_EQ(failure(points, {0.0, 1.0, NAN}, 0.5), TrajectoryFailure::NotFinite);
    EXPECT_EQ(failure(points, {0.0, 1.0, 2.0}, 1.5), TrajectoryFailure::BadShape);
    EXPECT_EQ(failure(points * NAN, {0.0, 1.0, 2.0}, 0.5), TrajectoryFailure::NotFinite);
    // Both windows are the whole time.
    EXPECT_EQ(failure(points, {0.0, 1.0, 2.0}, 1.0), TrajectoryFailure::Singular);
}

TEST(ViaPointSpline, EqualPointsAreAPauseNotAnError)
{
    const Eigen::MatrixXd points = Eigen::MatrixXd::Constant(7, 5, 0.25);
    const ViaPointSpline spline = *ViaPointSpline::through(points, ramp(5), 0.5, Rise::quintic());
    ViaPointSpline::State<3> state;
    spline.at<3>(1.7, state);
    EXPECT_LT((state.col(0) - points.col(0)).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT(state.rightCols(3).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_TRUE(spline.scaledTo(std::vector<MotionLimits>(7, {1.0, 1.0, 1.0})));
}
}  // namespace
}  // namespace narrows
