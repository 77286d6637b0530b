// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/Rise.h"

namespace narrows
{
namespace
{
constexpr double shortest = 1e-6, longest = 1e6;  // durations; beyond them derivatives leave the range of doubles
constexpr double leastShape = 0.01, largestShape = 600.0;
// Least L (u - a), relative to L (|u| + |a|): a pole that is nearer cannot be told from one that is there.
constexpr double leastGap = 1e-9;
}  // namespace

Rise::Rise(Kind kind, double logBase, double clock, double logEnd)
  : kind_(kind), logBase_(logBase), clock_(clock), logEnd_(logEnd), end_(fallFromOne(logEnd, std::exp(logEnd)))
{
}

OrFailure<Rise> Rise::paper(double n, double a, double duration)
{
    if (!std::isfinite(n) || !std::isfinite(a) || !std::isfinite(duration))
        return TrajectoryFailure::NotFinite;
    if (duration < shortest || duration > longest)
        return TrajectoryFailure::BadTime;
    if (!(n > 1.0))
        return TrajectoryFailure::BadBase;
    // u = t + T/t - 1 is least at sqrt(T), or at T where that comes first.
    const double least = duration > 1.0 ? 2.0 * std::sqrt(duration) - 1.0 : duration;
    if (!(least - a > leastGap * (least + std::abs(a))))
        return TrajectoryFailure::Pole;
    const double logBase = std::log(n);
    return Rise(Kind::Homotopy, logBase, duration, logBase * (a - duration));
}

OrFailure<Rise> Rise::resting(double shape)
{
    if (!std::isfinite(shape))
        return TrajectoryFailure::NotFinite;
    if (shape < leastShape || shape > largestShape)
        return TrajectoryFailure::BadShape;
    return Rise(Kind::Homotopy, shape, 1.0 + 2.0 / shape, -std::log1p(2.0 / shape));
}

OrFailure<Rise> Rise::symmetric(double shape)
{
    OrFailure<Rise> half = resting(shape);
    if (half)
        half.value->kind_ = Kind::Symmetric;
    return half;
}

Rise Rise::quintic()
{
    return Rise(Kind::Quintic, 1.0, 1.0, -1.0);
}
}  // namespace narrows
