// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/FullHomotopy.h"

#include <stdexcept>

#include <Eigen/QR>

namespace narrows
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

FullHomotopy::FullHomotopy(std::shared_ptr<const Repulsion> repulsion, const VectorXd &start, const VectorXd &goal,
                           const MatrixXd &rows)
  : repulsion_(std::move(repulsion)), ends_({repulsion_}, start, goal), rows_(rows)
{
    const Eigen::Index n = start.size();
    if (rows.rows() != n || rows.cols() != n || !rows.allFinite())
        throw std::invalid_argument("there must be one row of constants per joint, each with one number per joint");
    if (n > 1 && rows.topRows(n - 1).transpose().colPivHouseholderQr().rank() < n - 1)
        throw std::invalid_argument("the linear rows are dependent: they leave more than one direction free");
    atStart_ = -rows * ends_.difference;
    atStart_[n - 1] += ends_.startValues[0] - ends_.goalValues[0];
}

VectorXd FullHomotopy::startPoint() const
{
    VectorXd z(equations() + 1);
    z << ends_.start, 0.0;
    return z;
}

VectorXd FullHomotopy::goalPoint() const
{
    VectorXd z(equations() + 1);
    z << ends_.goal, 1.0;
    return z;
}

void FullHomotopy::configuration(const VectorXd &z, VectorXd &w) const
{
    w = z.head(z.size() - 1);
}

void FullHomotopy::evaluate(CurvePoint &point) const
{
    thread_local Repulsion::Sample sample;
    const Eigen::Index n = rows_.rows();
    configuration(point.z, point.w);
    repulsion_->evaluate(point.w, sample);
    point.residual.noalias() = rows_ * (point.w - ends_.goal);
    point.residual[n - 1] += sample.value - ends_.goalValues[0];
    point.residual -= (1.0 - point.z[n]) * atStart_;
    point.jacobian.resize(n, n + 1);
    point.jacobian.leftCols(n) = rows_;
    point.jacobian.row(n - 1).head(n) += sample.gradient.transpose();
    point.jacobian.col(n) = atStart_;
    std::swap(point.poles, sample.poles);
}

MatrixXd rowsOfSlice(const VectorXd &direction, double coupling)
{
    const Eigen::Index n = direction.size();
    if (n == 0 || !direction.allFinite() || !(direction.norm() > 0.0))
        throw std::invalid_argument("a direction must be finite and must not vanish");
    const VectorXd unit = direction.normalized();
    const MatrixXd basis = Eigen::HouseholderQR<MatrixXd>(unit).householderQ();
    MatrixXd rows(n, n);
    rows.topRows(n - 1) = basis.rightCols(n - 1).transpose();
    rows.row(n - 1) = coupling * unit.transpose();
    return rows;
}
}  // namespace narrows
