// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// Part of a way over time: column k multiplies (time since the piece began)^k.
struct WayPiece
{
    /// Above 0, in s.
    double duration;
    Eigen::RowVectorXd coefficients;  ///< from the constant one on
};

/// From rest at 0 to rest at a distance.
using SegmentWay = std::vector<WayPiece>;

/// The sum of its pieces' durations.
double timeOf(const SegmentWay &way);

// distance > 0, limits valid().

/// fastestMove(): piecewise constant jerk.
SegmentWay sevenPhaseWay(double distance, const MotionLimits &limits);

/// The fastest under limits of velocity and acceleration; jerk is infinite.
SegmentWay trapezoidWay(double distance, const MotionLimits &limits);

/// The fastest quintic step; its peaks in unit time over a unit distance are 15/8, 10/sqrt(3) and 60.
SegmentWay quinticWay(double distance, const MotionLimits &limits);

/// A third of the time speeding up evenly, a third steady, a third slowing down. \param time > 0
SegmentWay blendedWay(double distance, double time);
}  // namespace narrows
