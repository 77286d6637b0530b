// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/InterpolatingSplines.h"

#include <random>

#include <gtest/gtest.h>

#include "ViaPointPaper.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"

namespace narrows
{
namespace
{
struct Timed
{
    Eigen::MatrixXd points;
    std::vector<double> times;
};

Timed randomTask(Eigen::Index joints, Eigen::Index count)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-3.0, 3.0), step(0.3, 2.0);
    Timed task{Eigen::MatrixXd::NullaryExpr(joints, count, [&] { return angle(random); }), {0.0}};
    while (static_cast<Eigen::Index>(task.times.size()) < count)
        task.times.push_back(task.times.back() + step(random));
    return task;
}

Timed timed(const ViaPointTask &task)
{
    return {Eigen::RowVector3d(task.start, task.via, task.goal), {0.0, task.viaTime, task.duration}};
}

using MakeSpline = OrFailure<PolynomialTrajectory> (*)(const Eigen::MatrixXd &, const std::vector<double> &);

void expectThrough(const PolynomialTrajectory &motion, const Timed &task)
{
    JointTrajectory::States state;
    for (Eigen::Index i = 0; i < task.points.cols(); ++i)
    {
        motion.at(task.times[static_cast<std::size_t>(i)], state);
        EXPECT_LT((state.col(0) - task.points.col(i)).cwiseAbs().maxCoeff(), 1e-11);
    }
}

/// The largest jump of a derivative at inner knots, relative to 1.
double innerJump(const PolynomialTrajectory &motion, Eigen::Index order)
{
    double largest = 0.0;
    for (Eigen::Index joint = 0; joint < motion.joints(); ++joint)
    {
        const std::unique_ptr<PiecewiseMotion> one = motion.joint(joint);
        const std::vector<double> knots = one->knots();
        for (std::size_t k = 1; k + 1 < knots.size(); ++k)
            largest = std::max(largest, std::abs(one->over(k, knots[k])[static_cast<std::size_t>(order)].lower -
                                                 one->over(k - 1, knots[k])[static_cast<std::size_t>(order)].lower));
    }
    return largest;
}

TEST(InterpolatingSplines, CubicIsSmoothToTheSecondDerivativeAndStopsAtBothEnds)
{
    for (const Eigen::Index count : {2, 3, 9, 60})
    {
        const Timed task = randomTask(3, count);
        const PolynomialTrajectory motion = *cubicSpline(task.points, task.times);
        expectThrough(motion, task);
        EXPECT_LT(innerJump(motion, 1), 1e-10);
        EXPECT_LT(innerJump(motion, 2), 1e-9);
        EXPECT_EQ(innerJump(motion, 3) > 0.1, count > 2);
        JointTrajectory::States state;
        for (const double end : {0.0, motion.duration()})
        {
            motion.at(end, state);
            EXPECT_LT(state.col(1).cwiseAbs().maxCoeff(), 1e-10);
            EXPECT_GT(state.col(2).cwiseAbs().maxCoeff(), 0.1);
        }
    }
}

TEST(InterpolatingSplines, QuinticIsSmoothToTheFourthDerivativeAndRestsAtBothEnds)
{
    for (const Eigen::Index count : {2, 3, 9, 60})
    {
        const Timed task = randomTask(3, count);
        const PolynomialTrajectory motion = *quinticSpline(task.points, task.times);
        expectThrough(motion, task);
        for (Eigen::Index order = 1; order <= 4; ++order)
            EXPECT_LT(innerJump(motion, order), 1e-6);
        JointTrajectory::States state;
        for (const double end : {0.0, motion.duration()})
        {
            motion.at(end, state);
            EXPECT_LT(state.middleCols(1, 2).cwiseAbs().maxCoeff(), 1e-9);
        }
    }
}

TEST(InterpolatingSplines, OfTwoPointsAreTheCubicAndTheQuinticStep)
{
    const Eigen::MatrixXd unit = Eigen::RowVector2d(0.0, 1.0);
    const PolynomialTrajectory cubic = *cubicSpline(unit, {0.0, 1.0}), quintic = *quinticSpline(unit, {0.0, 1.0});
    EXPECT_LT((cubic.pieces()[0].coefficients - Eigen::RowVector4d(0.0, 0.0, 3.0, -2.0)).cwiseAbs().maxCoeff(), 1e-12);
    Eigen::RowVectorXd step(6);
    step << 0.0, 0.0, 0.0, 10.0, -15.0, 6.0;
    EXPECT_LT((quintic.pieces()[0].coefficients - step).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(InterpolatingSplines, SixthOrderIsThePapersEquation27)
{
    const Timed task = timed(paperTaskC);
    const PolynomialTrajectory motion = *sixthOrder(task.points, task.times);
    Eigen::RowVectorXd exact(7);
    exact << 30.0, 0.0, 0.0, 2540.0 / 9.0, -2390.0 / 9.0, 2300.0 / 27.0, -2240.0 / 243.0;
    EXPECT_LT((motion.pieces()[0].coefficients - exact).cwiseAbs().maxCoeff(), 1e-11);
    expectThrough(motion, task);
}

/// Largest jerk and overshoot on the paper's problems A, B, C.
TEST(InterpolatingSplines, OfThePapersProblems)
{
    const struct
    {
        MakeSpline make;
        double jerk[3], overshoot[3];
    } rows[] = {{quinticSpline, {140.7, 7604.7, 1444.44}, {0.0, 128.1, 5.09}},
                {sixthOrder, {150.2, 5300.3, 1693.3}, {0.0, 339.1, 5.62}},
                {cubicSpline, {32.9, 2384.9, 413.3}, {0.0, 36.0, 3.85}}};
    const ViaPointTask tasks[] = {paperTaskA, paperTaskB, paperTaskC};
    for (const auto &row : rows)
        for (int i = 0; i < 3; ++i)
        {
            const Timed task = timed(tasks[i]);
            const PolynomialTrajectory motion = *row.make(task.points, task.times);
            const MotionPeaks peaks = motionPeaks(*motion.joint(0));
            EXPECT_NEAR(peaks[3].magnitude(), row.jerk[i], 0.1) << i;
            EXPECT_NEAR(ViaPointTrajectory::overshoot(tasks[i], peaks), row.overshoot[i], 0.1) << i;
            // From rest the cubic begins with a jump of acceleration.
            EXPECT_EQ(std::isfinite(trajectoryPeaks(motion)[0][3].magnitude()), row.make != cubicSpline);
        }
}

TEST(InterpolatingSplines, RefuseByName)
{
    const Timed task = randomTask(2, 3);
    for (const MakeSpline make : {MakeSpline(cubicSpline), MakeSpline(quinticSpline), MakeSpline(sixthOrder)})
    {
        EXPECT_EQ(make(task.points.leftCols(2), task.times).failure, TrajectoryFailure::BadCount);
        EXPECT_EQ(make(task.points, {0.0, 2.0, 1.0}).failure, TrajectoryFailure::BadTime);
        EXPECT_EQ(make(task.points, {0.0, 1.0, 1e7}).failure, TrajectoryFailure::BadTime);
        EXPECT_EQ(make(task.points, {0.0, 1.0, NAN}).failure, TrajectoryFailure::NotFinite);
        EXPECT_EQ(make(task.points * INFINITY, task.times).failure, TrajectoryFailure::NotFinite);
    }
    EXPECT_EQ(sixthOrder(task.points.leftCols(2), {0.0, 1.0}).failure, TrajectoryFailure::BadCount);
}
}  // namespace
}  // namespace narrows
