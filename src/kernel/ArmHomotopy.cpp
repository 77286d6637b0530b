// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ArmHomotopy.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/QR>

namespace narrows
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// The unit vector that all rows but the last are orthogonal to; its largest entry is positive.
VectorXd freeDirection(const MatrixXd &rows)
{
    const Eigen::Index n = rows.rows();
    if (n == 1)
        return VectorXd::Ones(1);
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.topRows(n - 1).transpose());
    if (qr.rank() < n - 1)
        throw std::invalid_argument("the linear rows are dependent: they leave more than one direction free");
    const MatrixXd basis = qr.householderQ();
    VectorXd direction = basis.col(n - 1);
    Eigen::Index largest;
    direction.cwiseAbs().maxCoeff(&largest);
    return direction[largest] < 0.0 ? VectorXd(-direction) : direction;
}
}  // namespace

ArmHomotopy::ArmHomotopy(ArmRepulsion repulsion, const VectorXd &start, const VectorXd &goal)
  : repulsion_(std::move(repulsion)), start_(start), goal_(goal)
{
    if (start.size() != dimension() || goal.size() != dimension() || !start.allFinite() || !goal.allFinite())
        throw std::invalid_argument("start and goal must be finite configurations of the arm");
    difference_ = goal - start;
    startValue_ = repulsion_.value(start);
    goalValue_ = repulsion_.value(goal);
    if (!std::isfinite(startValue_) || !std::isfinite(goalValue_))
        throw std::invalid_argument("start or goal lies on a pole");
}

ArmHomotopy ArmHomotopy::fromRows(ArmRepulsion repulsion, const VectorXd &start, const VectorXd &goal,
                                  const MatrixXd &rows)
{
    ArmHomotopy homotopy(std::move(repulsion), start, goal);
    const int n = homotopy.dimension();
    if (rows.rows() != n || rows.cols() != n || !rows.allFinite())
        throw std::invalid_argument("there must be one row of constants per joint, each with one number per joint");
    homotopy.rows_ = rows;
    homotopy.direction_ = freeDirection(rows);
    homotopy.strength_ = rows.row(n - 1).dot(homotopy.direction_);
    homotopy.atStart_ = rows * (start - goal);
    homotopy.atStart_[n - 1] += homotopy.startValue_ - homotopy.goalValue_;
    return homotopy;
}

ArmHomotopy ArmHomotopy::fromDirection(ArmRepulsion repulsion, const VectorXd &start, const VectorXd &goal,
                                       const VectorXd &direction, double strength)
{
    const Eigen::Index n = repulsion.dimension();
    if (direction.size() != n || !direction.allFinite() || !(direction.norm() > 0.0))
        throw std::invalid_argument("the direction must have one number per joint and must not vanish");
    if (!std::isfinite(strength) || strength == 0.0)
        throw std::invalid_argument("the strength of the direction must be finite and not 0");
    const VectorXd unit = direction.normalized();
    const MatrixXd basis = Eigen::HouseholderQR<MatrixXd>(unit).householderQ();
    MatrixXd rows(n, n);
    rows.topRows(n - 1) = basis.rightCols(n - 1).transpose();
    rows.row(n - 1) = strength * unit.transpose();

    ArmHomotopy homotopy = fromRows(std::move(repulsion), start, goal, rows);
    homotopy.direction_ = unit;  // fromRows chose the sign; the caller's s is meant
    homotopy.strength_ = strength;
    return homotopy;
}

void ArmHomotopy::residual(ConfigurationRef w, double lambda, const ArmRepulsion::Sample &sample, VectorXd &h) const
{
    h.noalias() = rows_ * (w - goal_);
    h[dimension() - 1] += sample.value - goalValue_;
    h -= (1.0 - lambda) * atStart_;
}

void ArmHomotopy::jacobian(const ArmRepulsion::Sample &sample, MatrixXd &jacobian) const
{
    const int n = dimension();
    jacobian.resize(n, n + 1);
    jacobian.leftCols(n) = rows_;
    jacobian.row(n - 1).head(n) += sample.gradient.transpose();
    jacobian.col(n) = atStart_;
}

void ArmHomotopy::planePoint(double lambda, double s, VectorXd &w) const
{
    w = start_ + lambda * difference_ + s * direction_;
}

double ArmHomotopy::planeResidual(double lambda, double s, const ArmRepulsion::Sample &sample) const
{
    return strength_ * s + sample.value - (1.0 - lambda) * startValue_ - lambda * goalValue_;
}

Eigen::Vector2d ArmHomotopy::planeGradient(const ArmRepulsion::Sample &sample) const
{
    return {difference_.dot(sample.gradient) + startValue_ - goalValue_, strength_ + direction_.dot(sample.gradient)};
}
}  // namespace narrows
