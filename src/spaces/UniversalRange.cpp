// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/UniversalRange.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace narrows
{
namespace
{
constexpr double rounding = 1e-12;  // radians
constexpr int halvings = 60;        // past the last bit of a double

double squaredHalfSine(double angle)
{
    const double sine = std::sin(0.5 * angle);
    return sine * sine;
}

Interval within(double most, const std::optional<Interval> &limits)
{
    if (!limits)
        return {-most, most};
    return {std::max(-most, limits->lower), std::min(most, limits->upper)};
}

double leastOf(const Interval &interval)
{
    return std::min(std::max(0.0, interval.lower), interval.upper);
}
}  // namespace

UniversalRange::UniversalRange(const UniversalLimit &limit, const std::optional<Interval> &first,
                               const std::optional<Interval> &second)
  : limit_(limit),
    first_(within(limit.maxAngle, first)),
    second_(within(limit.maxAngle, second)),
    most_(squaredHalfSine(limit.maxAngle)),
    tolerated_(squaredHalfSine(limit.maxAngle + rounding))
{
    if (first_.lower > first_.upper || second_.lower > second_.upper ||
        !bendsAtMost(most_, leastOf(first_), leastOf(second_)))
        throw std::invalid_argument("the limits of joints " + std::to_string(limit.first) + " and " +
                                    std::to_string(limit.second) + " leave the universal joint no position");
}

bool UniversalRange::bendsAtMost(double squaredSine, double a, double b) const
{
    // sin^2(bend / 2) = (1 - cos a cos b) / 2, written so that small angles keep their digits.
    const double x = squaredHalfSine(a);
    const double y = squaredHalfSine(b);
    return x + y - 2.0 * x * y <= squaredSine;
}

bool UniversalRange::contains(const double *joints) const
{
    const double a = joints[limit_.first];
    const double b = joints[limit_.second];
    // The angles are those of a posture that turns by less than a right angle, not of one that bends as far by winding.
    return a >= first_.lower - rounding && a <= first_.upper + rounding && b >= second_.lower - rounding &&
           b <= second_.upper + rounding && bendsAtMost(tolerated_, a, b);
}

void UniversalRange::enforce(double *joints) const
{
    double &a = joints[limit_.first];
    double &b = joints[limit_.second];
    a = std::min(std::max(a, first_.lower), first_.upper);
    b = std::min(std::max(b, second_.lower), second_.upper);
    if (bendsAtMost(tolerated_, a, b))
        return;
    const double restA = leastOf(first_);
    const double restB = leastOf(second_);
    double inside = 0.0;
    double outside = 1.0;
    for (int i = 0; i < halvings; ++i)
    {
        const double middle = 0.5 * (inside + outside);
        (bendsAtMost(most_, restA + middle * (a - restA), restB + middle * (b - restB)) ? inside : outside) = middle;
    }
    a = restA + inside * (a - restA);
    b = restB + inside * (b - restB);
}
}  // namespace narrows
