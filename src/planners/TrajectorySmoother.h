// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/trajectory/OverlappedMoves.h"

namespace narrows
{
/// Whether a motion is free at all times and within the limits of its joints' positions. Must not depend on its pace.
using TrajectoryProof = std::function<bool(const JointTrajectory &)>;

/// How long the smoother searches.
struct SmoothingOptions
{
    int evaluations = 400;  ///< >= 0, of the search; 0: only what bisection finds
    int viaNumbers = 60;    ///< >= 0; vertices are moved too if all but the ends have at most so many coordinates
    std::function<bool()> interrupted = {};  ///< if set, asked between evaluations; the best so far is returned
};

/// What the smoother has made of a polyline.
struct SmoothedTrajectory
{
    PolynomialTrajectory motion;  ///< keeps the limits exactly as far as it is short: one of them is reached
    double stopDuration;          ///< how long the motion with stops takes, >= motion.duration()
    bool blended;                 ///< proven; else nothing better than stops was, whose way is the polyline itself
    int evaluations;              ///< motions looked at
    int proofs;                   ///< of these, how many the proof was asked about
};

/// The shortest motion that was found along a polyline: OverlappedMoves whose corners are cut as far as the proof lets
/// them (bisection, corner by corner), then overlaps, paces and perhaps vertices by NLopt's SBPLX. Never longer than
/// the fastest motion with stops, which needs no proof if the polyline is free. Limits are kept at all times, by closed
/// form. Deterministic, as far as the proof is.
/// Fails as OverlappedMoves::along() does, or with BadCount if options are negative.
OrFailure<SmoothedTrajectory> smoothTrajectory(const Eigen::MatrixXd &vertices, const std::vector<MotionLimits> &limits,
                                               const TrajectoryProof &proof, const SmoothingOptions &options = {});
}  // namespace narrows
