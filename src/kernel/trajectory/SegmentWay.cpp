// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/SegmentWay.h"

#include "kernel/trajectory/JerkLimitedMove.h"

namespace narrows
{
namespace
{
constexpr double shortestPhase = 1e-12;  // of a segment's time: below it a phase is rounding

/// Way of constant jerks or, without jerk, accelerations: integrated phase by phase.
/// \param phases duration, acceleration at the beginning, jerk
SegmentWay integrated(const std::vector<std::array<double, 3>> &phases)
{
    double whole = 0.0;
    for (const auto &phase : phases)
        whole += phase[0];
    SegmentWay way;
    double position = 0.0, velocity = 0.0;
    for (const auto &[time, acceleration, jerk] : phases)
    {
        if (time <= shortestPhase * whole)
            continue;
        way.push_back({time, Eigen::RowVector4d(position, velocity, acceleration / 2.0, jerk / 6.0)});
        position += time * (velocity + time * (acceleration / 2.0 + time * jerk / 6.0));
        velocity += time * (acceleration + time * jerk / 2.0);
    }
    return way;
}

SegmentWay ramps(double rampTime, double cruiseTime, double acceleration)
{
    return integrated({{rampTime, acceleration, 0.0}, {cruiseTime, 0.0, 0.0}, {rampTime, -acceleration, 0.0}});
}
}  // namespace

double timeOf(const SegmentWay &way)
{
    double sum = 0.0;
    for (const WayPiece &piece : way)
        sum += piece.duration;
    return sum;
}

SegmentWay sevenPhaseWay(double distance, const MotionLimits &limits)
{
    const JerkLimitedMove move = fastestMove(distance, limits);
    const double j = limits.jerk, a = j * move.jerkTime;
    return integrated({{move.jerkTime, 0.0, j},
                       {move.steadyTime, a, 0.0},
                       {move.jerkTime, a, -j},
                       {move.cruiseTime, 0.0, 0.0},
                       {move.jerkTime, 0.0, -j},
                       {move.steadyTime, -a, 0.0},
                       {move.jerkTime, -a, j}});
}

SegmentWay trapezoidWay(double distance, const MotionLimits &limits)
{
    const double v = limits.velocity, a = limits.acceleration;
    return distance > v * v / a ? ramps(v / a, distance / v - v / a, a) : ramps(std::sqrt(distance / a), 0.0, a);
}

SegmentWay quinticWay(double distance, const MotionLimits &limits)
{
    // Peaks of the step in unit time: 15/8, 10/sqrt 3, 60.
    const double T =
        std::max({1.875 * distance / limits.velocity, std::sqrt(10.0 / std::sqrt(3.0) * distance / limits.acceleration),
                  std::cbrt(60.0 * distance / limits.jerk)});
    Eigen::RowVectorXd coefficients(6);
    coefficients << 0.0, 0.0, 0.0, 10.0, -15.0 / T, 6.0 / (T * T);
    return {{T, distance / (T * T * T) * coefficients}};
}

SegmentWay blendedWay(double distance, double time)
{
    const double third = time / 3.0;
    return ramps(third, third, 0.5 * distance / (third * third));
}
}  // namespace narrows
