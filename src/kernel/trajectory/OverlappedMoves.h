// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/JerkLimitedMove.h"
#include "kernel/trajectory/PolynomialTrajectory.h"
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
/// How the moves along a polyline follow each other.
struct MoveTiming
{
    Eigen::VectorXd overlaps;  ///< one per corner, in [0, 1]: how much of the shorter of the two moves that meet there
                               ///< they share; 0 is a stop
    Eigen::VectorXd slowness;  ///< one per segment, > 0: its duration over that of the fastest move
};

/// Along a polyline, one move from rest to rest for each segment; a move may begin before the one before has ended, so
/// that the corner between them is cut:
///     q(t) = p_0 + sum of (p_k - p_(k-1)) s_k(t),
/// s_k the fastest jerk-limited move from 0 to 1 (JerkLimitedMove) under the limits of all joints along that segment.
/// Without overlaps this is the fastest motion that stops at every vertex; it depends continuously on the timing, a
/// homotopy from the polyline to a motion that does not stop. Jerk is constant by pieces.
class OverlappedMoves
{
public:
    /// \param vertices one column per vertex, one row per joint; neighbours that differ by no more than 1e-12 of the
    /// largest coordinate count as one
    /// \param limits one for each joint
    /// Fails with BadCount, NotFinite, BadLimit, NoMotion (no two vertices differ) or BadTime (more than 1e6).
    static OrFailure<OverlappedMoves> along(const Eigen::MatrixXd &vertices, const std::vector<MotionLimits> &limits);

    Eigen::Index segments() const { return vertices_.cols() - 1; }  ///< between vertices
    /// Distinct ones.
    const Eigen::MatrixXd &vertices() const { return vertices_; }
    /// No overlaps, no slowness.
    MoveTiming stops() const;
    /// The same limits along another polyline. \pre as many vertices, finite, neighbours distinct
    OverlappedMoves along(Eigen::MatrixXd vertices) const { return {std::move(vertices), limits_}; }

    /// \pre the timing is as MoveTiming says. Limits are kept if there are no overlaps; else see stretchToLimits().
    PolynomialTrajectory motion(const MoveTiming &timing) const;

    /// The least factor by which motion(timing) must be stretched in time to keep the limits; below 1 if it can be
    /// faster. In closed form: the jerk is constant by pieces.
    double stretchToLimits(const PolynomialTrajectory &motion) const;

private:
    OverlappedMoves(Eigen::MatrixXd vertices, std::vector<MotionLimits> limits);

    Eigen::MatrixXd vertices_;
    std::vector<MotionLimits> limits_;
    std::vector<JerkLimitedMove> moves_;  ///< from 0 to 1
};
}  // namespace narrows
