// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// The fastest motion from rest to rest over a distance under limits of velocity, acceleration and jerk: seven phases
/// of constant jerk +j, 0, -j, 0, -j, 0, +j, some of which may last no time.
struct JerkLimitedMove
{
    double jerkTime;    ///< of each of the four phases with jerk
    double steadyTime;  ///< of each of the two with constant acceleration; 0 if its limit is not reached
    double cruiseTime;  ///< at constant velocity; 0 if its limit is not reached

    double duration() const { return 4.0 * jerkTime + 2.0 * steadyTime + cruiseTime; }  ///< of all phases
};

/// \param distance > 0
/// \throws std::invalid_argument unless distance and limits are positive and finite
JerkLimitedMove fastestMove(double distance, const MotionLimits &limits);
}  // namespace narrows
