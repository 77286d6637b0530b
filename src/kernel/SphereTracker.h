// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/HomotopyCurve.h"
#include "kernel/Trace.h"

namespace narrows
{
/// How the curve is followed by hyperspheres, as the paper does.
struct SphereOptions
{
    double radius = 0.02;  ///< of every hypersphere, in the metric of z; the paper uses 0.001 to 0.04
    /// >= 1; more end the trace.
    int maxSpheres = 20000;
    double tolerance = 1e-11;  ///< on the corrector's last update
    /// >= 1; more end the trace.
    int maxCorrections = 30;
    TraceWindow window;  ///< where the curve is followed
};

/// The paper's algorithm to the letter (HPPM-PRA, Algorithm 1, Section 2), meant for a FullHomotopy: hyperspheres of
/// fixed radius along the curve, Euler's predictor for the first two, then the secant through the last two centers, and
/// Broyden's corrector, started from the analytic Jacobian at the predicted point. Where a sphere's step crosses lambda
/// = 1, the root there is refined by Newton's method and compared with the goal.
///
/// Numerical trouble never throws: the status says how the trace ended.
/// \throws std::invalid_argument if an option is out of range.
Trace traceSpheres(const HomotopyCurve &curve, const SphereOptions &options = {},
                   const std::function<bool()> &interrupt = {});
}  // namespace narrows
