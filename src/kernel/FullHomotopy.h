// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/HomotopyCurve.h"
#include "kernel/HomotopyEnds.h"

namespace narrows
{
/// The Newton homotopy as the paper prints it, in v + 1 dimensions (HPPM-PRA, Eq. 24-26):
///
///   f(w) = A (w - w_goal) + e_v (W(w) - W(w_goal)),   H(w, lambda) = f(w) - (1 - lambda) f(w_start) = 0,
///
/// with z = (w, lambda). All rows but the last are linear, so that the curve lies in a plane: SliceHomotopy::fromRows
/// gives the same curve there.
class FullHomotopy : public HomotopyCurve
{
public:
    /// \param rows A, the paper's constants a_{k,j}, one row per equation; W joins the last one (its l_v)
    /// \throws std::invalid_argument if the matrix is not square of the robot's dimension, not finite, or its rows but
    /// the last are dependent; or if the ends are impossible (see HomotopyEnds).
    FullHomotopy(std::shared_ptr<const Repulsion> repulsion, const Eigen::VectorXd &start, const Eigen::VectorXd &goal,
                 const Eigen::MatrixXd &rows);

    /// As they were given.
    const Eigen::MatrixXd &rows() const { return rows_; }

    int equations() const override { return static_cast<int>(rows_.rows()); }  ///< one a row
    double lambdaScale() const override { return 1.0; }
    Eigen::VectorXd startPoint() const override;
    Eigen::VectorXd goalPoint() const override;
    /// H and its Jacobian at point.z.
    void evaluate(CurvePoint &point) const override;
    void configuration(const Eigen::VectorXd &z, Eigen::VectorXd &w) const override;

private:
    std::shared_ptr<const Repulsion> repulsion_;
    HomotopyEnds ends_;
    Eigen::MatrixXd rows_;
    Eigen::VectorXd atStart_;  ///< f(w_start)
};

/// Constants a_{k,j} whose slice has the direction N and the coupling c: an orthonormal basis across N, then c N.
/// \throws std::invalid_argument if the direction vanishes or is not finite.
Eigen::MatrixXd rowsOfSlice(const Eigen::VectorXd &direction, double coupling);
}  // namespace narrows
