// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SliceHomotopy.h"

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

SliceHomotopy::SliceHomotopy(std::vector<std::shared_ptr<const Repulsion>> repulsions, const VectorXd &start,
                             const VectorXd &goal, const MatrixXd &directions, const VectorXd &couplings,
                             const JointSchedule &schedule)
  : repulsions_(std::move(repulsions)),
    ends_(repulsions_, start, goal),
    directions_(directions),
    couplings_(couplings),
    scale_(ends_.difference.norm()),
    unitDifference_(ends_.difference.stableNormalized())
{
    if (!schedule.held.empty() && static_cast<Eigen::Index>(schedule.held.size()) != start.size())
        throw std::invalid_argument("a schedule must say of every joint whether it is held");
    if (!(schedule.share >= 0.0 && schedule.share < 1.0))
        throw std::invalid_argument("joints can be held for a share of the way from 0 to less than 1");
    if (!schedule.empty())
        schedule_ = schedule;
    const auto k = static_cast<Eigen::Index>(repulsions_.size());
    if (directions.rows() != start.size() || directions.cols() != k || !directions.allFinite())
        throw std::invalid_argument("each direction must have one finite number per joint, each repulsion a direction");
    if (couplings.size() != k || !couplings.allFinite() || (couplings.array() == 0.0).any())
        throw std::invalid_argument("each direction needs a coupling that is finite and not 0");
    for (Eigen::Index i = 0; i < k; ++i)
    {
        if (!(directions.col(i).norm() > 0.0))
            throw std::invalid_argument("a direction must not vanish");
        directions_.col(i).normalize();
    }
    if (k > 1 && directions_.colPivHouseholderQr().rank() < k)
        throw std::invalid_argument("the directions of a slice must be independent");
}

SliceHomotopy SliceHomotopy::fromRows(std::shared_ptr<const Repulsion> repulsion, const VectorXd &start,
                                      const VectorXd &goal, const MatrixXd &rows)
{
    const Eigen::Index n = start.size();
    if (n == 0 || rows.rows() != n || rows.cols() != n || !rows.allFinite())
        throw std::invalid_argument("there must be one row of constants per joint, each with one number per joint");
    const VectorXd direction = freeDirection(rows);
    const VectorXd coupling = rows.row(n - 1) * direction;
    return SliceHomotopy({std::move(repulsion)}, start, goal, direction, coupling);
}

VectorXd SliceHomotopy::startPoint() const
{
    return VectorXd::Zero(equations() + 1);
}

VectorXd SliceHomotopy::goalPoint() const
{
    return scale_ * VectorXd::Unit(equations() + 1, equations());
}

void SliceHomotopy::configuration(const VectorXd &z, VectorXd &w) const
{
    const Eigen::Index k = couplings_.size();
    if (schedule_.held.empty())
        w = ends_.start + z[k] * unitDifference_ + z[0] * directions_.col(0);
    else
    {
        w = ends_.start + z[0] * directions_.col(0);
        for (Eigen::Index j = 0; j < w.size(); ++j)
            w[j] += schedule_.progress(static_cast<std::size_t>(j), z[k] / scale_).value * ends_.difference[j];
    }
    for (Eigen::Index i = 1; i < k; ++i)
        w += z[i] * directions_.col(i);
}

void SliceHomotopy::scheduledRate(double lambda, VectorXd &rate) const
{
    rate = unitDifference_;
    for (std::size_t j = 0; j < schedule_.held.size(); ++j)
        rate[static_cast<Eigen::Index>(j)] *= schedule_.progress(j, lambda).rate;
}

void SliceHomotopy::evaluate(CurvePoint &point) const
{
    thread_local Repulsion::Sample sample;
    thread_local VectorXd scheduled;
    const Eigen::Index k = couplings_.size();
    const double lambda = point.z[k] / scale_;
    configuration(point.z, point.w);
    point.residual.resize(k);
    point.jacobian.resize(k, k + 1);
    if (k > 1)
        point.poles.clear();
    if (!schedule_.held.empty())
        scheduledRate(lambda, scheduled);
    const VectorXd &rate = schedule_.held.empty() ? unitDifference_ : scheduled;
    for (Eigen::Index i = 0; i < k; ++i)
    {
        repulsions_[i]->evaluate(point.w, sample);
        const double first = ends_.startValues[i], last = ends_.goalValues[i];
        point.residual[i] = couplings_[i] * point.z[i] + sample.value - (1.0 - lambda) * first - lambda * last;
        for (Eigen::Index j = 0; j < k; ++j)
            point.jacobian(i, j) = directions_.col(j).dot(sample.gradient);
        point.jacobian(i, i) += couplings_[i];
        point.jacobian(i, k) = rate.dot(sample.gradient) + (first - last) / scale_;
        if (k == 1)
            std::swap(point.poles, sample.poles);  // no copy: repulsions write them anew each time
        else
            point.poles.insert(point.poles.end(), sample.poles.begin(), sample.poles.end());
    }
}
}  // namespace narrows
