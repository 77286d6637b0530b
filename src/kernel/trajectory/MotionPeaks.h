// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "kernel/trajectory/Rise.h"

namespace narrows
{
/// A coordinate over time, smooth between knots.
class PiecewiseMotion
{
public:
    virtual ~PiecewiseMotion() = default;

    /// Where pieces begin and end, ascending, at least two.
    virtual std::vector<double> knots() const = 0;
    /// Everything that position and derivatives up to the fourth are while t runs over a span of piece `piece`, ends
    /// included as limits from within.
    virtual Series<4, Enclosure> over(std::size_t piece, const Enclosure &t) const = 0;
};

/// Least and largest value of a derivative, and where.
struct Extremes
{
    double lowest;     ///< least value
    double lowestAt;   ///< when
    double highest;    ///< greatest value
    double highestAt;  ///< when

    double magnitude() const { return std::max(-lowest, highest); }  ///< the greatest absolute value
};

/// Of position, velocity, acceleration and jerk. The values are attained at the times given; nothing lies further out
/// than the tolerance times the magnitude that belongs to the order.
using MotionPeaks = std::array<Extremes, 4>;

/// Branch and bound over all pieces, with interval arithmetic: nothing between samples is missed.
/// \param tolerance relative to the magnitude of the derivative (of the position: to the larger of that and its range)
MotionPeaks motionPeaks(const PiecewiseMotion &motion, double tolerance = 1e-9);

/// By this factor peaks of the default tolerance are taken to be higher where they are held against limits.
constexpr double peakSlack = 1.0 + 2e-9;

/// Of velocity, acceleration and jerk; each > 0 and finite.
struct MotionLimits
{
    double velocity;      ///< units of the joint per s
    double acceleration;  ///< per s^2
    double jerk;          ///< per s^3

    /// Whether all are positive and finite.
    bool valid() const;
};

/// By how much the motion must be stretched in time to keep the limits: the least factor if above 1, else the motion
/// can be that much faster.
double stretchFor(const MotionPeaks &peaks, const MotionLimits &limits);
}  // namespace narrows
