// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/PolynomialTrajectory.h"

#include <gtest/gtest.h>

#include "kernel/trajectory/TrajectoryPeaks.h"
#include "kernel/trajectory/ViaPointSpline.h"

namespace narrows
{
namespace
{
/// Two joints: t^2 and 1 - t^3 for a second, then straight on.
PolynomialTrajectory twoPieces()
{
    Eigen::MatrixXd first(2, 4), second(2, 2);
    first << 0.0, 0.0, 1.0, 0.0,  //
        1.0, 0.0, 0.0, -1.0;
    second << 1.0, 2.0,  //
        0.0, -3.0;
    return PolynomialTrajectory({{1.0, first}, {2.0, second}});
}

TEST(PolynomialTrajectory, EvaluatesPositionAndThreeDerivatives)
{
    const PolynomialTrajectory motion = twoPieces();
    EXPECT_EQ(motion.joints(), 2);
    EXPECT_EQ(motion.duration(), 3.0);
    JointTrajectory::States state, expected(2, 4);
    motion.at(0.5, state);
    expected << 0.25, 1.0, 2.0, 0.0,  //
        0.875, -0.75, -3.0, -6.0;
    EXPECT_LT((state - expected).cwiseAbs().maxCoeff(), 1e-15);
    motion.at(2.0, state);
    expected << 3.0, 2.0, 0.0, 0.0,  //
        -3.0, -3.0, 0.0, 0.0;
    EXPECT_LT((state - expected).cwiseAbs().maxCoeff(), 1e-15);
    motion.at(7.0, state);
    expected << 5.0, 0.0, 0.0, 0.0,  //
        -6.0, 0.0, 0.0, 0.0;
    EXPECT_LT((state - expected).cwiseAbs().maxCoeff(), 1e-14);
    motion.at(-1.0, state);
    expected << 0.0, 0.0, 0.0, 0.0,  //
        1.0, 0.0, 0.0, 0.0;
    EXPECT_LT((state - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(PolynomialTrajectory, EnclosesItsSamples)
{
    const PolynomialTrajectory motion = twoPieces().stretched(1.7);
    JointTrajectory::States state;
    for (Eigen::Index joint = 0; joint < 2; ++joint)
    {
        const std::unique_ptr<PiecewiseMotion> one = motion.joint(joint);
        const std::vector<double> knots = one->knots();
        for (std::size_t piece = 0; piece + 1 < knots.size(); ++piece)
            for (int i = 0; i < 10; ++i)
            {
                const double step = (knots[piece + 1] - knots[piece]) / 10.0;
                const Enclosure span(knots[piece] + i * step, knots[piece] + (i + 1) * step);
                const Series<4, Enclosure> all = one->over(piece, span);
                for (int j = 1; j < 10; ++j)
                {
                    motion.at(span.lower + 0.1 * j * (span.upper - span.lower), state);
                    for (std::size_t k = 0; k < 4; ++k)
                    {
                        EXPECT_GE(state(joint, static_cast<Eigen::Index>(k)), all[k].lower - 1e-13);
                        EXPECT_LE(state(joint, static_cast<Eigen::Index>(k)), all[k].upper + 1e-13);
                    }
                }
            }
    }
}

TEST(PolynomialTrajectory, StretchingDividesDerivatives)
{
    const PolynomialTrajectory motion = twoPieces(), slow = motion.stretched(2.0);
    EXPECT_EQ(slow.duration(), 6.0);
    JointTrajectory::States state, half;
    motion.at(0.7, state);
    slow.at(1.4, half);
    for (Eigen::Index k = 0; k < 4; ++k)
        EXPECT_LT((half.col(k) * std::pow(2.0, k) - state.col(k)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(PolynomialTrajectory, RefusesWhatIsNoMotion)
{
    const Eigen::MatrixXd good = Eigen::MatrixXd::Ones(2, 3);
    EXPECT_THROW(PolynomialTrajectory({}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{0.0, good}}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{INFINITY, good}}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{1.0, good * NAN}}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{1.0, good}, {1.0, good.topRows(1)}}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{1.0, Eigen::MatrixXd(2, 0)}}), std::invalid_argument);
    EXPECT_THROW(PolynomialTrajectory({{1.0, good}, {1e-17, good}}), std::invalid_argument);
}

TEST(TrajectoryPeaksOfJoints, JumpsMakeHigherDerivativesInfinite)
{
    const PolynomialTrajectory motion = twoPieces();
    // Joint 0: acceleration 2 from rest and to 0; velocity 2 at the end. Joint 1: velocity -3 at the end.
    const Series<3> jumps = largestJumps(*motion.joint(0));
    EXPECT_NEAR(jumps[0], 0.0, 1e-15);
    EXPECT_NEAR(jumps[1], 2.0, 1e-15);
    EXPECT_NEAR(jumps[2], 2.0, 1e-15);
    const std::vector<MotionPeaks> peaks = trajectoryPeaks(motion);
    ASSERT_EQ(peaks.size(), 2u);
    EXPECT_NEAR(peaks[0][1].magnitude(), 2.0, 1e-12);
    EXPECT_NEAR(peaks[1][1].magnitude(), 3.0, 1e-12);
    EXPECT_EQ(peaks[1][2].magnitude(), INFINITY);
    EXPECT_EQ(peaks[1][3].magnitude(), INFINITY);
    const TimeStretch stretch = stretchFor(peaks, {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}});
    EXPECT_FALSE(stretch.keepsAll);
    EXPECT_NEAR(stretch.factor, 3.0, 1e-7);
}

TEST(TrajectoryPeaksOfJoints, RestingSplinesHaveNone)
{
    Eigen::MatrixXd points(2, 4);
    points << 0.0, 1.0, -1.0, 0.5,  //
        1.0, 1.0, 1.0, 1.0;         // this one rests
    for (const Rise &rise : {*Rise::resting(1.0), *Rise::symmetric(0.75), Rise::quintic()})
    {
        const ViaPointSpline spline = *ViaPointSpline::through(points, {0.0, 1.0, 1.5, 3.0}, 0.5, rise);
        const std::vector<MotionPeaks> peaks = trajectoryPeaks(spline);
        EXPECT_TRUE(std::isfinite(peaks[0][3].magnitude()));
        EXPECT_LT(peaks[1][3].magnitude(), 1e-10);
        const TimeStretch stretch = stretchFor(peaks, {{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}});
        EXPECT_TRUE(stretch.keepsAll);
        EXPECT_NEAR(stretch.factor, spline.scaledTo({{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}})->duration() / 3.0, 1e-7);
    }
}

TEST(TrajectoryPeaksOfJoints, StretchRefusesWhatIsNoLimit)
{
    const std::vector<MotionPeaks> peaks = trajectoryPeaks(twoPieces());
    EXPECT_THROW(stretchFor(peaks, {{1.0, 1.0, 1.0}}), std::invalid_argument);
    EXPECT_THROW(stretchFor(peaks, {{1.0, 1.0, 1.0}, {1.0, 0.0, 1.0}}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
