// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/ArmHomotopy.h"
#include "kernel/Trace.h"

namespace narrows
{
/// Steps are arc lengths in the plane, measured in (|D| lambda, s), which are joint radians.
struct PlaneOptions
{
    double firstStep = 0.02;
    double maxStep = 0.35;
    double minStep = 1e-10;   ///< below this the curve is given up
    double tolerance = 1e-3;  ///< in (0, 1), part of the step; a correction shorter than this is the last. Newton's
                              ///< method squares errors: it leaves less than maxTurn * tolerance^2 of the step
    double contraction = 0.5;    ///< in (0, 1); each correction must be this much shorter than the one before
    double maxCorrection = 0.5;  ///< a step whose corrections add up to more than this part of it is rejected
    double maxTurn = 0.7;        ///< radians; a step along which the tangent turns more is rejected
    double poleShrink = 0.1;     ///< in (0, 1); a step on which an obstacle function falls below this part is rejected
    int maxSteps = 5000;         ///< accepted and rejected together
    TraceWindow window;
};

/// Follows the same curve as `traceSpheres` in its exact two-dimensional form: predictor by tangent and the last step's
/// curvature, Newton's corrector along the gradient, and a step length that grows while the curve is straight and
/// shrinks whenever the corrector contracts slowly, moves far, the tangent turns, or a pole comes near. The side on
/// which Phi is positive stays on the same hand, so that folds do not reverse the direction. At every crossing of
/// lambda = 1 the root is refined; s = 0 is the goal.
///
/// Numerical trouble never throws: the status says how the trace ended.
/// \throws std::invalid_argument if an option is out of range.
Trace tracePlane(const ArmHomotopy &homotopy, const PlaneOptions &options = {},
                 const std::function<bool()> &interrupt = {});
}  // namespace narrows
