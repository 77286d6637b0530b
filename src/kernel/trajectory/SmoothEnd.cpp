// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/SmoothEnd.h"

#include <cmath>

#include "kernel/trajectory/Rise.h"

namespace narrows
{
OrFailure<double> flatEnd(double n, double duration)
{
    const double a = duration - std::log(duration) / std::log(n);
    const OrFailure<Rise> rise = Rise::paper(n, std::isfinite(n) && n > 1.0 && duration > 0.0 ? a : 0.0, duration);
    if (!rise)
        return rise.failure;
    return a;
}

OrFailure<EndParameters> flatEndTwice(double duration)
{
    if (!std::isfinite(duration))
        return TrajectoryFailure::NotFinite;
    const double logBase = 2.0 / (duration - 1.0);
    const double n = std::exp(logBase);
    if (!(duration > 1.0) || !std::isfinite(n))
        return TrajectoryFailure::BadTime;
    return EndParameters{n, duration - std::log(duration) / logBase};
}
}  // namespace narrows
