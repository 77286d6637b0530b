// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>

namespace narrows
{
/// The damped least-squares answer of the joints to an error of the tip: J^T (J J^T + damping)^-1 error.
/// \param jacobian Dim x joints
/// \param damping >= 0, in the units of J J^T
template <int Dim>
Eigen::VectorXd dampedStep(const Eigen::Matrix<double, Dim, Eigen::Dynamic> &jacobian,
                           const Eigen::Matrix<double, Dim, 1> &error, double damping)
{
    using Square = Eigen::Matrix<double, Dim, Dim>;
    const Square damped = jacobian * jacobian.transpose() + damping * Square::Identity();
    return jacobian.transpose() * (damped.inverse() * error);
}
}  // namespace narrows
