// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/trajectory/JointTrajectory.h"

namespace narrows
{
/// The largest jump of position, velocity, acceleration and jerk at knots; of velocity to jerk at the ends too, where
/// the joint comes from rest and returns to it.
Series<3> largestJumps(const PiecewiseMotion &motion);

/// Certified extremes of every joint. Where a derivative jumps by more than 1e-7 of its peak, the ends included, all
/// higher ones are infinite: a motor would need an impulse there, however finite the values beside it.
std::vector<MotionPeaks> trajectoryPeaks(const JointTrajectory &trajectory, double tolerance = 1e-9);

/// The largest magnitudes over all joints, of position, velocity, acceleration and jerk.
Series<3> largestPeaks(const std::vector<MotionPeaks> &peaks);

/// What uniform stretching in time can do for limits.
struct TimeStretch
{
    double factor;  ///< the least that keeps every limit that can be kept; 0 if nothing moves
    bool keepsAll;  ///< whether those are all: an infinite peak stays infinite
};

/// \param limits one for each joint
/// \throws std::invalid_argument if their number differs from the joints' or one is not valid()
TimeStretch stretchFor(const std::vector<MotionPeaks> &peaks, const std::vector<MotionLimits> &limits);
}  // namespace narrows
