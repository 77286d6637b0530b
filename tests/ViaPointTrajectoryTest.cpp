// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/ViaPointTrajectory.h"

#include <gtest/gtest.h>

#include "ViaPointPaper.h"
#include "kernel/trajectory/SmoothEnd.h"
#include "kernel/trajectory/ViaPointIteration.h"

namespace narrows
{
namespace
{
constexpr double halfDigit = 0.5e-4;  // of numbers that the paper prints with four decimals

void expectPrinted(const PaperTrajectory &paper, double viaLog, double goalLog)
{
    const PaperLogs logs = paperLogs(paper.task, paper.parameters, trajectoryOf(paper).feedback());
    // It rounds some and cuts off others ("5.4327...").
    EXPECT_NEAR(logs.viaLog, viaLog, 1.1 * halfDigit);
    EXPECT_NEAR(logs.goalLog, goalLog, 1.1 * halfDigit);
}

TEST(ViaPointTrajectory, HasThePrintedParametersOfTheFigures)
{
    expectPrinted(paperFig2, 5.4327, -4.0586);
    expectPrinted(paperFig4, -16.6294, -14.8052);
    expectPrinted(paperFig6, -0.7130, -1.0328);
    expectPrinted(paperFig8, -6.0657, -0.9204);
    expectPrinted(paperFig9, -3.0399, -2.6193);
    EXPECT_NEAR(trajectoryOf(paperFig2).feedback(), -11.9635, halfDigit);
    EXPECT_NEAR(trajectoryOf(paperFig3).feedback(), -27.2749, halfDigit);
    EXPECT_NEAR(trajectoryOf(paperFig6).feedback(), -21.2603, halfDigit);
}

TEST(ViaPointTrajectory, Equation10NeedsTheViasOwnModifier)
{
    PaperTrajectory printed = paperFig8;
    printed.parameters.aVia = printed.parameters.a;
    EXPECT_NEAR(paperLogs(printed.task, printed.parameters, trajectoryOf(paperFig8).feedback()).viaLog, -7.3998,
                halfDigit);
}

TEST(ViaPointTrajectory, Figure1IsNormalisedAtOne)
{
    // zeta = t_s - log_n(S_f (n^t_s - n^a)) of S_f = 4 is 1 - log_n(n^t_s - n^a): the trajectory is 1 at time 1.
    const ViaPointTask task{0.0, 1.0, 4.0, 1.0, 3.0};
    EXPECT_NEAR(paperLogs(task, {2.0, 0.0, 2.0, 0.0}, 0.0).goalLog, 1.0 - std::log2(7.0), 1e-15);
    EXPECT_NEAR(4.0 * Rise::paper(2.0, 0.0, 3.0)->at<0>(1.0 / 3.0)[0], 1.0, 1e-15);
}

TEST(ViaPointTrajectory, Figure3sFeedbackIsImpossibleWithThePrintedParameters)
{
    // S_v does not depend on n_v and a_v, all that the paper says it changed.
    PaperTrajectory printed = paperFig2;
    printed.parameters.aVia = 1.2481;
    EXPECT_EQ(trajectoryOf(printed).feedback(), trajectoryOf(paperFig2).feedback());
    EXPECT_NEAR(trajectoryOf(paperFig3).at<1>(3.0)[1], 0.0, 0.025);  // "velocity too close to zero"
}

TEST(ViaPointTrajectory, PassesThroughItsPoints)
{
    for (const PaperTrajectory &paper : {paperFig2, paperFig3, paperFig4, paperFig6, paperFig8, paperFig9})
    {
        const ViaPointTrajectory motion = trajectoryOf(paper);
        EXPECT_EQ(motion.at<0>(0.0)[0], paper.task.start);
        EXPECT_NEAR(motion.at<0>(paper.task.viaTime)[0], paper.task.via, 1e-12);
        EXPECT_NEAR(motion.at<0>(paper.task.duration)[0], paper.task.goal, 1e-12);
        EXPECT_EQ(motion.at<3>(-1.0), (Series<3>{paper.task.start, 0.0, 0.0, 0.0}));
        EXPECT_NEAR(motion.viaJump()[0], 0.0, 1e-12);
    }
}

TEST(ViaPointTrajectory, Figure8JumpsInAccelerationAsPrinted)
{
    const ViaPointTrajectory motion = trajectoryOf(paperFig8);
    EXPECT_NEAR(motion.viaJump()[1], -0.0019, halfDigit);
    EXPECT_NEAR(motion.viaJump()[2], 219.824, 0.5e-3 + 0.5e-4);
    EXPECT_NEAR(motionPeaks(motion)[0].highest, 180.4, 0.05);
}

TEST(ViaPointTrajectory, FiguresThatThePaperCallsComplexOrSharpAreSo)
{
    const MotionPeaks complex = motionPeaks(trajectoryOf(paperFig4));
    EXPECT_NEAR(complex[0].lowest, -1070.2, 0.05);
    EXPECT_NEAR(complex[0].highest, 129.5, 0.05);
    EXPECT_NEAR(complex[1].lowest, -2150.3, 0.05);
    EXPECT_NEAR(complex[3].lowest, -97034.5, 0.05);
    EXPECT_NEAR(1.0 / (1.0 - trajectoryOf(paperFig4).viaShare()), 249.0, 0.5);
    EXPECT_NEAR(trajectoryOf(paperFig2).at<1>(3.0)[1], 12.35, 0.005);
    EXPECT_NEAR(trajectoryOf(paperFig6).at<1>(3.0)[1], 109.76, 0.005);
    EXPECT_NEAR(motionPeaks(trajectoryOf(paperFig2))[3].magnitude(), 151.0, 0.5);
    EXPECT_NEAR(motionPeaks(trajectoryOf(paperFig6))[3].magnitude(), 88.3, 0.05);
    EXPECT_NEAR(motionPeaks(trajectoryOf(paperFig8))[3].magnitude(), 3286.8, 0.05);
}

TEST(ViaPointTrajectory, Figure9IsNotContinuousInAcceleration)
{
    const ViaPointTrajectory motion = trajectoryOf(paperFig9);
    EXPECT_NEAR(motion.viaJump()[1], -157.98, 0.005);
    EXPECT_NEAR(motion.viaJump()[2], 157.98, 0.005);
    const MotionPeaks peaks = motionPeaks(motion);
    EXPECT_NEAR(peaks[3].highest, 1510.0, 0.05);  // printed: 1394
    EXPECT_NEAR(peaks[3].lowest, -1332.9, 0.05);  // printed: -1177
}

TEST(ViaPointTrajectory, JumpIsWhatOneSidedLimitsDifferBy)
{
    for (const PaperTrajectory &paper : {paperFig2, paperFig4, paperFig8, paperFig9})
    {
        const ViaPointTrajectory motion = trajectoryOf(paper);
        const double t = paper.task.viaTime;
        const Series<3> left = motion.at<3>(t), right = motion.at<3>(std::nextafter(t, 9.0)), jump = motion.viaJump();
        for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(right[k] - left[k], jump[k], 1e-9 * (1.0 + std::abs(left[k])));
    }
}

TEST(ViaPointTrajectory, IterationTendsToTheClosedFormInThePrintedCounts)
{
    const auto count = [](const PaperTrajectory &paper, double first)
    {
        const IterationResult result = iterateFeedback(paper.task, paper.parameters, first, 100000);
        EXPECT_TRUE(result.converged);
        EXPECT_NEAR(result.feedback, trajectoryOf(paper).feedback(), 1e-9 * std::abs(result.feedback));
        return result.steps;
    };
    EXPECT_EQ(count(paperFig2, paperTaskA.goal), 40);
    EXPECT_EQ(count(paperFig6, paperTaskB.via), 58);
    EXPECT_EQ(count(paperFig8, paperTaskC.goal), 12);
    EXPECT_EQ(count(paperFig9, paperTaskC.via), 28);
    // No start gives them all.
    EXPECT_EQ(count(paperFig2, paperTaskA.start), 33);
    EXPECT_EQ(count(paperFig2, paperTaskA.via), 39);
    EXPECT_EQ(count(paperFig6, paperTaskB.start), 57);
    EXPECT_EQ(count(paperFig6, paperTaskB.goal), 59);
    EXPECT_EQ(count(paperFig8, paperTaskC.start), 12);
    EXPECT_EQ(count(paperFig8, paperTaskC.via), 11);
    EXPECT_EQ(count(paperFig9, paperTaskC.start), 29);
    EXPECT_EQ(count(paperFig9, paperTaskC.goal), 29);
    EXPECT_NEAR(count(paperFig4, paperTaskB.via), 7067, 30);  // hangs on the last bits: K = 0.996
}

TEST(ViaPointTrajectory, ClosedFormHoldsWhereTheIterationDiverges)
{
    const PaperTrajectory divergent{{10.0, 25.0, 62.0, 2.4, 3.0}, {3.0, 2.3, 1.7, 0.05}};
    const ViaPointTrajectory motion = trajectoryOf(divergent);
    EXPECT_NEAR(motion.viaShare(), 1.277, 5e-4);
    EXPECT_NEAR(motion.at<0>(2.4)[0], 25.0, 1e-12);
    EXPECT_NEAR(motion.at<0>(3.0)[0], 62.0, 1e-12);
    EXPECT_FALSE(iterateFeedback(divergent.task, divergent.parameters, 25.0, 1000).converged);
}

TEST(ViaPointTrajectory, RefusesByName)
{
    const auto failure = [](const ViaPointTask &task, const PaperParameters &parameters)
    {
        return ViaPointTrajectory::paper(task, parameters).failure;
    };
    const PaperParameters good = paperFig2.parameters;
    for (const double viaTime : {0.0, -1.0, 3.0, 4.0})
        EXPECT_EQ(failure({0.0, 1.0, 2.0, viaTime, 3.0}, good), TrajectoryFailure::BadTime);
    EXPECT_EQ(failure({0.0, 1.0, NAN, 1.5, 3.0}, good), TrajectoryFailure::NotFinite);
    EXPECT_EQ(failure(paperTaskA, {2.5, 2.7, 2.0, 0.05}), TrajectoryFailure::Pole);
    EXPECT_EQ(failure(paperTaskA, {2.5, -1.4, 2.0, 1.5}), TrajectoryFailure::Pole);
    EXPECT_EQ(failure(paperTaskA, {2.5, -1.4, 1.0, 0.05}), TrajectoryFailure::BadBase);
    EXPECT_EQ(ViaPointTrajectory::full(paperTaskA, 1.0, 1.0).failure, TrajectoryFailure::Singular);
    EXPECT_EQ(ViaPointTrajectory::full(paperTaskA, 1.0, -1.0).failure, TrajectoryFailure::BadShape);
    EXPECT_EQ(ViaPointTrajectory::resting({0.0, 1.0, 2.0, 3.0, 3.0}, 1.0, 1.0).failure, TrajectoryFailure::BadTime);
}

TEST(ViaPointTrajectory, RefusesTheParametersWhereTheGoalsTermIsDoneAtTheVia)
{
    // K passes 1 as a grows; in between lies the a that determines nothing.
    const ViaPointTask task{10.0, 25.0, 62.0, 2.4, 3.0};
    double below = 0.0, above = 2.3;
    for (int i = 0; i < 60; ++i)
    {
        const double a = 0.5 * (below + above);
        const OrFailure<ViaPointTrajectory> motion = ViaPointTrajectory::paper(task, {3.0, a, 1.7, 0.05});
        if (!motion)
        {
            EXPECT_EQ(motion.failure, TrajectoryFailure::Singular);
            return;
        }
        (motion->viaShare() < 1.0 ? below : above) = a;
    }
    FAIL() << "K = 1 was accepted";
}

TEST(ViaPointTrajectory, StaysWhereNothingNeedsToMove)
{
    const ViaPointTrajectory motion = *ViaPointTrajectory::full({7.0, 7.0, 7.0, 1.0, 2.0}, 1.0, 2.0);
    for (const double t : {0.0, 0.3, 1.0, 2.0, 5.0})
        EXPECT_EQ(motion.at<3>(t), (Series<3>{7.0, 0.0, 0.0, 0.0}));
}

TEST(ViaPointTrajectory, ConditionsAtTheViaMakeItC1OrC2)
{
    PaperTrajectory paper = paperFig9;
    paper.parameters.aVia = *flatEnd(5.0, 1.5);
    EXPECT_NEAR(trajectoryOf(paper).viaJump()[1], 0.0, 1e-11);
    EXPECT_GT(std::abs(trajectoryOf(paper).viaJump()[2]), 1.0);
    const EndParameters twice = *flatEndTwice(1.5);
    paper.parameters.nVia = twice.n;
    paper.parameters.aVia = twice.a;
    EXPECT_NEAR(trajectoryOf(paper).viaJump()[1], 0.0, 1e-11);
    EXPECT_NEAR(trajectoryOf(paper).viaJump()[2], 0.0, 1e-9);
    EXPECT_GT(std::abs(trajectoryOf(paper).viaJump()[3]), 1.0);
}

TEST(ViaPointTrajectory, RestingIsSmoothAtTheViaAndRestsAtTheEndInAnyUnit)
{
    const ViaPointTrajectory motion = *ViaPointTrajectory::resting(paperTaskC, 1.5, 0.7);
    EXPECT_NEAR(motion.viaJump()[1], 0.0, 1e-10);
    EXPECT_NEAR(motion.viaJump()[2], 0.0, 1e-9);
    EXPECT_NEAR(motion.at<1>(3.0)[1], 0.0, 1e-11);
    EXPECT_NEAR(motion.at<2>(3.0)[2], 0.0, 1e-10);
    const ViaPointTrajectory milliseconds =
        *ViaPointTrajectory::resting({30.0, 180.0, 120.0, 1500.0, 3000.0}, 1.5, 0.7);
    EXPECT_NEAR(milliseconds.at<0>(1000.0)[0], motion.at<0>(1.0)[0], 1e-12);
    // The paper's function, with its "-1", changes its way with the unit of time.
    const ViaPointTrajectory tenths = trajectoryOf({{-12.0, 5.0, 30.0, 15.0, 30.0}, paperFig2.parameters});
    EXPECT_NEAR(trajectoryOf(paperFig2).at<0>(1.0)[0], -5.260, 5e-4);
    EXPECT_NEAR(tenths.at<0>(10.0)[0], -5.097, 5e-4);
}

TEST(ViaPointTrajectory, FullIsSmoothWithinAndRestsAtBothEnds)
{
    const ViaPointTrajectory motion = *ViaPointTrajectory::full(paperTaskC, std::exp(0.430), std::exp(-0.474));
    EXPECT_NEAR(motion.at<0>(1.5)[0], 180.0, 1e-12);
    EXPECT_EQ(motion.viaJump(), Series<3>{});
    EXPECT_EQ(motion.at<3>(0.0), (Series<3>{30.0, 0.0, 0.0, 0.0}));
    EXPECT_NEAR(motion.at<1>(3.0)[1], 0.0, 1e-11);
    EXPECT_NEAR(motion.at<2>(3.0)[2], 0.0, 1e-10);
    const MotionPeaks peaks = motionPeaks(motion);
    EXPECT_LE(ViaPointTrajectory::overshoot(paperTaskC, peaks), 0.4);
    EXPECT_NEAR(peaks[3].magnitude(), 1702.3, 0.05);
}
}  // namespace
}  // namespace narrows
