// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/CentredStep.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double leastRemainder = 0.03;  ///< of a row's length: what depends more on the rows before it is left out
constexpr double accuracy = 1e-3;        ///< of the half width
}  // namespace

void CentredStep::begin(const Configuration &q, const std::vector<GapCrossing> &crossings)
{
    start_ = q;
    crossings_ = crossings;
    linearize(start_);
    startRank_ = rank_;
    startBasis_ = basis_.leftCols(rank_);
}

void CentredStep::linearize(const Configuration &q)
{
    equations_->evaluate(q, crossings_, values_, rows_);
    basis_.resize(rows_.rows(), std::min(rows_.rows(), rows_.cols()));
    correction_.setZero(rows_.rows());
    counts_.assign(static_cast<std::size_t>(rows_.cols()), 0);
    rank_ = 0;
    // Modified Gram-Schmidt. The correction is built up by the way: orthogonal to the rows before, it settles one more.
    for (Eigen::Index row = 0; row < rows_.cols() && rank_ < basis_.cols(); ++row)
    {
        auto gradient = rows_.col(row);
        const double value = values_[row] + gradient.dot(correction_), length = gradient.norm();
        for (int i = 0; i < rank_; ++i)
            gradient -= basis_.col(i).dot(gradient) * basis_.col(i);
        const double remainder = gradient.norm();
        if (!(remainder > leastRemainder * length))
            continue;
        basis_.col(rank_) = gradient / remainder;
        correction_ -= value / remainder * basis_.col(rank_);
        counts_[static_cast<std::size_t>(row)] = 1;
        ++rank_;
    }
}

void CentredStep::tangent(const Configuration &direction, Eigen::VectorXd &result) const
{
    result = direction;
    for (int i = 0; i < startRank_; ++i)
        result -= startBasis_.col(i).dot(result) * startBasis_.col(i);
}

bool CentredStep::isCentred(const Configuration &q) const
{
    Eigen::Index row = 0;
    const auto isOff = [&](double allowed)
    {
        const Eigen::Index it = row++;
        return counts_[static_cast<std::size_t>(it)] != 0 && !(std::abs(values_[it]) <= accuracy * allowed);
    };
    for (const GapCrossing &crossing : crossings_)
    {
        const double halfWidth = equations_->halfWidth(q, crossing);
        if (isOff(halfWidth) || (crossing.square && isOff(std::sqrt(halfWidth))))
            return false;
    }
    return true;
}

bool CentredStep::reach(const Configuration &offset, Eigen::VectorXd &result)
{
    result = start_ + offset;
    for (int i = 0; i <= corrections; ++i)
    {
        linearize(result);
        if (isCentred(result))
            return true;
        if (!(correction_.norm() < 1.0))
            return false;
        result += correction_;
    }
    return false;
}
}  // namespace narrows
