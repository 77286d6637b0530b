// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/ArmRepulsion.h"

namespace narrows
{
/// The Newton homotopy that leads an arm from start to goal around poles (HPPM-PRA, Eq. 24-26):
///
///   f(w) = A (w - w_goal) + e_v (W(w) - W(w_goal)),   H(w, lambda) = f(w) - (1 - lambda) f(w_start) = 0.
///
/// All rows but the last are linear, so that the curve lies in the plane w = w_start + lambda D + s N with
/// D = w_goal - w_start and N the direction that those rows leave free, where the last row becomes
///
///   Phi(lambda, s) = c s + W(w) - (1 - lambda) W(w_start) - lambda W(w_goal) = 0,   c = a_v . N.
///
/// Nothing else of A matters to the curve. Immutable and thread-safe.
class ArmHomotopy
{
public:
    /// From the paper's constants a_{k,j}, one row per equation; W joins the last one (its l_v).
    /// \throws std::invalid_argument if the matrix is not square of the arm's dimension, not finite, or its rows but
    /// the last are dependent; if start or goal have the wrong size; if W is not finite at one of them.
    static ArmHomotopy fromRows(ArmRepulsion repulsion, const Eigen::VectorXd &start, const Eigen::VectorXd &goal,
                                const Eigen::MatrixXd &rows);

    /// From the plane's direction N (any length but 0) and c. The rows are completed by an orthonormal basis.
    /// \throws std::invalid_argument as fromRows; also if the direction vanishes or c is 0.
    static ArmHomotopy fromDirection(ArmRepulsion repulsion, const Eigen::VectorXd &start, const Eigen::VectorXd &goal,
                                     const Eigen::VectorXd &direction, double strength);

    int dimension() const { return repulsion_.dimension(); }
    const ArmRepulsion &repulsion() const { return repulsion_; }
    const Eigen::VectorXd &start() const { return start_; }
    const Eigen::VectorXd &goal() const { return goal_; }
    const Eigen::MatrixXd &rows() const { return rows_; }              ///< A
    const Eigen::VectorXd &difference() const { return difference_; }  ///< D
    const Eigen::VectorXd &direction() const { return direction_; }    ///< N, a unit vector
    double strength() const { return strength_; }                      ///< c

    /// H(w, lambda), given the sample of W at w.
    void residual(ConfigurationRef w, double lambda, const ArmRepulsion::Sample &sample, Eigen::VectorXd &h) const;
    /// dH/d(w, lambda): v rows, v + 1 columns.
    void jacobian(const ArmRepulsion::Sample &sample, Eigen::MatrixXd &jacobian) const;

    /// The point of the plane at (lambda, s).
    void planePoint(double lambda, double s, Eigen::VectorXd &w) const;
    /// Phi and its gradient over (lambda, s), given the sample of W at that point.
    double planeResidual(double lambda, double s, const ArmRepulsion::Sample &sample) const;
    Eigen::Vector2d planeGradient(const ArmRepulsion::Sample &sample) const;

private:
    ArmHomotopy(ArmRepulsion repulsion, const Eigen::VectorXd &start, const Eigen::VectorXd &goal);

    ArmRepulsion repulsion_;
    Eigen::VectorXd start_, goal_, difference_;
    Eigen::MatrixXd rows_;
    Eigen::VectorXd direction_;
    double strength_ = 1.0;
    double startValue_, goalValue_;  ///< W(w_start) and Q = W(w_goal)
    Eigen::VectorXd atStart_;        ///< f(w_start)
};
}  // namespace narrows
