// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// One joint's motion as a weighted sum of rises that all last for its whole duration:
///     q(t) = start + sum of c_i g_i(t / duration).
/// With rises that rest at both ends (Rise::resting, symmetric, quintic) so does the sum; it has no knot within.
class RiseSum : public PiecewiseMotion
{
public:
    /// \throws std::invalid_argument unless there are as many parts as rises, all numbers are finite and duration > 0
    RiseSum(double start, double duration, std::vector<Rise> rises, std::vector<double> parts);

    std::vector<double> knots() const override { return {0.0, duration_}; }
    Series<4, Enclosure> over(std::size_t piece, const Enclosure &t) const override;

private:
    double start_, duration_;
    std::vector<Rise> rises_;
    std::vector<double> parts_;
};

/// Own-clock rises (Rise::resting) of shapes e^-1.5 to e^3.3, evenly spread in the exponent: slow to sudden.
/// \pre count >= 2
std::vector<Rise> restingRises(int count);
}  // namespace narrows
