// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/HomotopyCurve.h"
#include "kernel/Trace.h"

namespace narrows
{
/// Lengths are in the metric of z, which for slices of joint space are joint radians. The defaults are what solved most
/// per evaluation on random arms of 3 to 10 links among circles (poles of strength 0.003 to 0.1).
struct TrackerOptions
{
    double firstStep = 0.02;   ///< length of the first step tried
    double maxStep = 0.35;     ///< branches nearer to each other than a quarter of this may be taken for each other
    double minStep = 1e-10;    ///< below this the curve is given up
    double endShare = 0.0;     ///< in [0, 1); so too below this part of the distance to the start or the goal,
                               ///< whichever is nearer: curves that end in the crossing of two poles cost fewer steps,
                               ///< while narrow ends may still be entered in steps as small as they need
    double tolerance = 1e-2;   ///< in (0, 1), part of the step; a correction shorter than this is the last (the first
                               ///< one if shorter than its cube). Newton's method squares errors: what is left is
                               ///< about maxTurn * tolerance^2 of the step
    double contraction = 0.5;  ///< in (0, 1); each correction must be this much shorter than the one before
    double maxCorrection = 0.5;          ///< a step whose corrections add up to more than this part of it is rejected
    double maxTurn = 0.7;                ///< radians; a step along which the tangent turns more is rejected
    double maxDeterminantRatio = 100.0;  ///< > 1; so is one that changes the augmented determinant by more than this
    double poleShrink = 0.1;  ///< in (0, 1); a step on which an obstacle function falls below this part is rejected
    int maxSteps = 5000;      ///< accepted and rejected together
    bool log = false;         ///< keep every step in Trace::log
    /// Whether the straight way between two configurations may be gone; a step whose ends it refuses is rejected. So
    /// that the chords of a curve that bends around an obstacle get short enough to stay outside.
    std::function<bool(const Eigen::VectorXd &from, const Eigen::VectorXd &to)> guard;
    TraceWindow window;  ///< where the curve is followed
};

/// Follows a homotopy curve from its start (lambda = 0): predictor by tangent and the last step's curvature, Newton's
/// corrector of least norm, and a step length that grows while the curve is straight and shrinks whenever the corrector
/// contracts slowly or moves far, the tangent turns, the determinant changes, or a pole comes near.
///
/// The sign of the augmented determinant det(dH/dz; tangent') never changes, so that folds do not reverse the
/// direction. Where the curve passes the goal it is followed into it, under the same limits, so that another root of
/// lambda = 1 nearby is not taken for it; likewise the start, for loops.
///
/// Numerical trouble never throws: the status says how the trace ended.
/// \throws std::invalid_argument if an option is out of range.
Trace track(const HomotopyCurve &curve, const TrackerOptions &options = {},
            const std::function<bool()> &interrupt = {});
}  // namespace narrows
