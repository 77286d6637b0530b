// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/JerkLimitedMove.h"

#include <stdexcept>

namespace narrows
{
JerkLimitedMove fastestMove(double distance, const MotionLimits &limits)
{
    if (!(distance > 0.0) || !std::isfinite(distance) || !limits.valid())
        throw std::invalid_argument("distance and limits must be positive and finite");
    const double v = limits.velocity, a = limits.acceleration, j = limits.jerk;
    const double toSteady = a / j;  // how long acceleration takes to reach its limit

    // To v and back, with or without a steady phase.
    const bool steady = v >= a * toSteady;
    const double jerkTime = steady ? toSteady : std::sqrt(v / j);
    const double steadyTime = steady ? v / a - toSteady : 0.0;
    const double cruiseTime = distance / v - (2.0 * jerkTime + steadyTime);
    if (cruiseTime >= 0.0)
        return {jerkTime, steadyTime, cruiseTime};

    // v is not reached. With T = 2 toSteady + steadyTime for each half, the distance is a (T - toSteady) T.
    if (distance >= 2.0 * a * toSteady * toSteady)
        return {toSteady, 0.5 * (std::sqrt(toSteady * toSteady + 4.0 * distance / a) - 3.0 * toSteady), 0.0};

    // Nor is a: distance = 2 j jerkTime^3.
    return {std::cbrt(0.5 * distance / j), 0.0, 0.0};
}
}  // namespace narrows
