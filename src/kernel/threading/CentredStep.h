// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/threading/GapEquations.h"

namespace narrows
{
/// Steps along the configurations in which chosen links cross gaps in the middle (GapEquations): the tangent there and,
/// back onto them, Newton's method with corrections of least norm. Equations that nearly depend on others before them
/// do not count (two links of one straight line give three, not four). Keeps its memory from one step to the next.
class CentredStep
{
public:
    using Configuration = GapEquations::Configuration;  ///< of the arm: joints as it counts them

    /// \pre the equations outlive this
    explicit CentredStep(const GapEquations &equations) : equations_(&equations) {}

    /// Chooses configuration and crossings.
    void begin(const Configuration &q, const std::vector<GapCrossing> &crossings);

    /// Equations that count, at the configuration of begin().
    int rank() const { return rank_; }

    /// The part of `direction` that keeps F where it is, to first order.
    void tangent(const Configuration &direction, Eigen::VectorXd &result) const;

    /// The configuration q + offset, q of begin(), brought to F = 0: to a thousandth of the half width of every gap,
    /// and of its root for F2, as far as they count. \return false if Newton's method does not get there in
    /// `corrections` steps; `result` is then where it ended
    bool reach(const Configuration &offset, Eigen::VectorXd &result);

    static constexpr int corrections = 8;  ///< of Newton's method, at most

private:
    /// F and an orthonormal basis of the rows of its derivative.
    void linearize(const Configuration &q);
    bool isCentred(const Configuration &q) const;

    const GapEquations *equations_;
    std::vector<GapCrossing> crossings_;
    Eigen::VectorXd start_;
    Eigen::VectorXd values_;
    Eigen::MatrixXd rows_;                ///< gradients in columns
    Eigen::MatrixXd basis_, startBasis_;  ///< orthonormal columns, the first rank_ of which count
    Eigen::VectorXd correction_;
    std::vector<char> counts_;  ///< per row
    int rank_ = 0, startRank_ = 0;
};
}  // namespace narrows
