// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/TrajectoryPeaks.h"

#include <stdexcept>

namespace narrows
{
namespace
{
constexpr double jumpTolerance = 1e-7;

/// Makes what lies above the first jump infinite.
void addImpulses(const Series<3> &jumps, const Series<3> &scale, MotionPeaks &peaks)
{
    bool impulse = false;
    for (std::size_t order = 0; order < peaks.size(); ++order)
    {
        if (impulse)
            peaks[order].highest = std::numeric_limits<double>::infinity(), peaks[order].lowest = -peaks[order].highest;
        impulse = impulse || jumps[order] > jumpTolerance * scale[order];
    }
}
}  // namespace

Series<3> largestJumps(const PiecewiseMotion &motion)
{
    const std::vector<double> knots = motion.knots();
    Series<3> jumps{};
    const auto note = [&jumps](const Series<4, Enclosure> &from, const Series<4, Enclosure> &to)
    {
        for (std::size_t order = 0; order < jumps.size(); ++order)
            jumps[order] = std::max(jumps[order], std::abs(to[order].lower - from[order].lower));
    };
    const auto resting = [](const Series<4, Enclosure> &state)
    {
        Series<4, Enclosure> rest{};
        rest[0] = state[0];
        return rest;
    };
    const std::size_t last = knots.size() - 2;
    const Series<4, Enclosure> start = motion.over(0, knots.front()), end = motion.over(last, knots.back());
    note(resting(start), start);
    note(end, resting(end));
    for (std::size_t piece = 0; piece < last; ++piece)
        note(motion.over(piece, knots[piece + 1]), motion.over(piece + 1, knots[piece + 1]));
    return jumps;
}

std::vector<MotionPeaks> trajectoryPeaks(const JointTrajectory &trajectory, double tolerance)
{
    std::vector<MotionPeaks> peaks;
    std::vector<Series<3>> jumps;
    for (Eigen::Index i = 0; i < trajectory.joints(); ++i)
    {
        const std::unique_ptr<PiecewiseMotion> motion = trajectory.joint(i);
        peaks.push_back(motionPeaks(*motion, tolerance));
        jumps.push_back(largestJumps(*motion));
    }
    // A joint that rests has rounding for peaks: jumps are compared with the peaks of all.
    const Series<3> scale = largestPeaks(peaks);
    for (std::size_t i = 0; i < peaks.size(); ++i)
        addImpulses(jumps[i], scale, peaks[i]);
    return peaks;
}

Series<3> largestPeaks(const std::vector<MotionPeaks> &peaks)
{
    Series<3> largest{};
    for (const MotionPeaks &own : peaks)
        for (std::size_t order = 0; order < largest.size(); ++order)
            largest[order] = std::max(largest[order], own[order].magnitude());
    return largest;
}

TimeStretch stretchFor(const std::vector<MotionPeaks> &peaks, const std::vector<MotionLimits> &limits)
{
    if (peaks.size() != limits.size())
        throw std::invalid_argument("every joint needs its limits");
    TimeStretch stretch{0.0, true};
    for (std::size_t i = 0; i < peaks.size(); ++i)
    {
        if (!limits[i].valid())
            throw std::invalid_argument("limits must be positive and finite");
        const double bounds[] = {limits[i].velocity, limits[i].acceleration, limits[i].jerk};
        for (std::size_t order = 1; order <= 3; ++order)
        {
            const double peak = peaks[i][order].magnitude();
            if (!std::isfinite(peak))
                stretch.keepsAll = false;
            else
                stretch.factor = std::max(
                    stretch.factor, std::pow(peak * peakSlack / bounds[order - 1], 1.0 / static_cast<double>(order)));
        }
    }
    return stretch;
}
}  // namespace narrows
