// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ViaPointPaper.h"
#include "kernel/trajectory/MotionPeaks.h"
#include "kernel/trajectory/RiseSum.h"

namespace narrows
{
namespace
{
/// theta = 30 + sum of c_i t^i, as the paper's Eq. 27.
class Polynomial : public PiecewiseMotion
{
public:
    Polynomial(double duration, std::vector<double> coefficients)
      : duration_(duration), coefficients_(std::move(coefficients))
    {
    }

    std::vector<double> knots() const override { return {0.0, duration_}; }

    Series<4, Enclosure> over(std::size_t, const Enclosure &t) const override
    {
        Series<4, Enclosure> result{};
        std::vector<double> c = coefficients_;
        for (Enclosure &value : result)
        {
            for (std::size_t i = c.size(); i-- > 0;)
                value = value * t + c[i];
            for (std::size_t i = 1; i < c.size(); ++i)
                c[i - 1] = static_cast<double>(i) * c[i];
            c.pop_back();
        }
        return result;
    }

private:
    double duration_;
    std::vector<double> coefficients_;
};

TEST(TrajectoryPeaks, AreThoseOfAPolynomial)
{
    // t^3 (t - 1)^3: extremes of position at 1/2, of velocity at (1 -+ 1/sqrt 5) / 2, of jerk at the ends.
    const MotionPeaks peaks = motionPeaks(Polynomial(1.0, {0.0, 0.0, 0.0, -1.0, 3.0, -3.0, 1.0}));
    EXPECT_NEAR(peaks[0].lowest, -1.0 / 64.0, 1e-10);
    EXPECT_NEAR(peaks[0].lowestAt, 0.5, 1e-4);
    const double x = 0.5 * (1.0 - 1.0 / std::sqrt(5.0));
    const double slope = 3.0 * std::pow(x * (x - 1.0), 2) * (2.0 * x - 1.0);
    EXPECT_NEAR(peaks[1].lowest, slope, 1e-10);
    EXPECT_NEAR(peaks[1].highest, -slope, 1e-10);
    EXPECT_NEAR(peaks[3].lowest, -6.0, 1e-12);
    EXPECT_NEAR(peaks[3].highest, 6.0, 1e-12);
}

TEST(TrajectoryPeaks, OfThePapersSixthOrderPolynomial)
{
    // Rest at 0 and 3 s and 180 at 1.5 s determine it: 7 conditions, 7 coefficients; Eq. 27 prints them rounded.
    const MotionPeaks exact =
        motionPeaks(Polynomial(3.0, {30.0, 0.0, 0.0, 2540.0 / 9.0, -2390.0 / 9.0, 2300.0 / 27.0, -2240.0 / 243.0}));
    EXPECT_NEAR(exact[0].highest, 185.62, 0.005);  // printed: 185.4 at 1.74
    EXPECT_NEAR(exact[0].highestAt, 1.701, 0.0005);
    EXPECT_NEAR(exact[3].highest, 1693.0, 0.5);
    EXPECT_NEAR(exact[3].lowest, -1294.0, 1.0);
    const Polynomial printed(3.0, {30.0, 0.0, 0.0, 282.22, -265.56, 85.19, -9.22});
    EXPECT_NEAR(printed.over(0, 1.74)[0].lower, 185.384, 0.0005);
    EXPECT_NEAR(printed.over(0, 3.0)[0].lower, 119.37, 0.005);
}

TEST(TrajectoryPeaks, SumsOfTwelveRisesNeedFarLessJerkThanTwo)
{
    // By a linear program over samples (analysis/rise_sums.py); what they promise is certified here.
    const struct
    {
        ViaPointTask task;
        double jerk;
        std::vector<double> parts;
    } sums[] = {
        {paperTaskA,
         72.2,
         {0.7947674822, -2.2957172554, 3.7192015168, 14.8233986627, 11.0156383422, 8.6424972563, 4.3919480249,
          0.5753809839, 0.2595007382, 0.0593559215, 0.0120409527, 0.0019873741}},
        {paperTaskB,
         7214.0,
         {15.9913200216, 242.9805657853, -745.1367445843, 876.3391660074, -504.3659169683, 328.1727156884,
          -300.6537224547, 69.5154497756, 47.1812324796, 18.2488200153, 3.5028933061, 0.2242209279}},
        {paperTaskC,
         1261.2,
         {9.0840764216, 13.7619595473, 129.6139478176, 115.8688166314, -116.085043951, -57.8034293538, -30.0502148945,
          14.5065697862, 7.0804726571, 3.2433140128, 0.7456558848, 0.0338754405}},
    };
    for (const auto &[task, jerk, parts] : sums)
    {
        const RiseSum motion(task.start, task.duration, restingRises(12), parts);
        EXPECT_NEAR(motion.over(0, task.viaTime)[0].lower, task.via, 1e-6);
        EXPECT_NEAR(motion.over(0, task.duration)[0].lower, task.goal, 1e-6);
        EXPECT_NEAR(motion.over(0, task.duration)[1].lower, 0.0, 1e-6);
        EXPECT_NEAR(motion.over(0, task.duration)[2].lower, 0.0, 1e-6);
        const MotionPeaks peaks = motionPeaks(motion, 1e-5);
        EXPECT_LE(peaks[3].magnitude(), jerk);
        EXPECT_LE(ViaPointTrajectory::overshoot(task, peaks), 0.41);
    }
}

TEST(TrajectoryPeaks, ASumOfOneRiseIsThatRise)
{
    const RiseSum sum(1.0, 2.0, {Rise::quintic()}, {3.0});
    const MotionPeaks peaks = motionPeaks(sum);
    EXPECT_NEAR(peaks[0].highest, 4.0, 1e-12);
    EXPECT_NEAR(peaks[1].highest, 3.0 * 1.875 / 2.0, 1e-8);
    EXPECT_NEAR(peaks[3].highest, 3.0 * 60.0 / 8.0, 1e-8);
    EXPECT_THROW(RiseSum(0.0, 0.0, {}, {}), std::invalid_argument);
    EXPECT_THROW(RiseSum(0.0, 1.0, {Rise::quintic()}, {}), std::invalid_argument);
    EXPECT_THROW(RiseSum(0.0, 1.0, {Rise::quintic()}, {double(NAN)}), std::invalid_argument);
}

TEST(TrajectoryPeaks, NothingThatDenseSamplesFindLiesFurtherOut)
{
    for (const PaperTrajectory &paper : {paperFig2, paperFig3, paperFig4, paperFig6, paperFig8, paperFig9})
    {
        const ViaPointTrajectory motion = trajectoryOf(paper);
        const MotionPeaks peaks = motionPeaks(motion);
        for (int i = 0; i <= 100000; ++i)
        {
            const Series<3> values = motion.at<3>(paper.task.duration * i / 100000.0);
            for (int k = 0; k < 4; ++k)
            {
                const double slack = 2e-9 * peaks[k].magnitude() + 1e-9;
                EXPECT_LE(values[k], peaks[k].highest + slack);
                EXPECT_GE(values[k], peaks[k].lowest - slack);
            }
        }
    }
}

TEST(TrajectoryPeaks, AreAttainedWhereTheySay)
{
    const ViaPointTrajectory motion = *ViaPointTrajectory::full(paperTaskC, 1.5, 0.6);
    const MotionPeaks peaks = motionPeaks(motion);
    for (int k = 0; k < 4; ++k)
    {
        EXPECT_NEAR(motion.at<3>(peaks[k].highestAt)[k], peaks[k].highest, 1e-9 * peaks[k].magnitude());
        EXPECT_NEAR(motion.at<3>(peaks[k].lowestAt)[k], peaks[k].lowest, 1e-9 * peaks[k].magnitude());
    }
}

TEST(TrajectoryPeaks, StretchingIsByTheLimitThatBindsMost)
{
    const MotionPeaks peaks{Extremes{}, Extremes{-2.0, 0.0, 1.0, 0.0}, Extremes{-1.0, 0.0, 16.0, 0.0},
                            Extremes{-27.0, 0.0, 1.0, 0.0}};
    EXPECT_NEAR(stretchFor(peaks, {1.0, 16.0, 27.0}), 2.0, 1e-15);
    EXPECT_NEAR(stretchFor(peaks, {2.0, 1.0, 27.0}), 4.0, 1e-15);
    EXPECT_NEAR(stretchFor(peaks, {20.0, 1600.0, 1.0}), 3.0, 1e-15);
    EXPECT_TRUE((MotionLimits{1.0, 1.0, 1.0}).valid());
    for (const double bad : {0.0, -1.0, double(INFINITY), double(NAN)})
    {
        EXPECT_FALSE((MotionLimits{bad, 1.0, 1.0}).valid());
        EXPECT_FALSE((MotionLimits{1.0, bad, 1.0}).valid());
        EXPECT_FALSE((MotionLimits{1.0, 1.0, bad}).valid());
    }
}
}  // namespace
}  // namespace narrows
