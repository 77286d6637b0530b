// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/LowDiscrepancy.h"

#include <cmath>
#include <stdexcept>

namespace narrows
{
LowDiscrepancy::LowDiscrepancy(const Eigen::VectorXd &offset) : point_(offset), step_(offset.size())
{
    if (offset.size() == 0 || !((offset.array() >= 0.0).all() && (offset.array() < 1.0).all()))
        throw std::invalid_argument("a sequence begins in the unit cube");
    const double power = 1.0 / (static_cast<double>(offset.size()) + 1.0);
    double root = 1.0, before = 0.0;
    while (std::abs(root - before) > 1e-15)  // contracts to less than a third each time
    {
        before = root;
        root = std::pow(1.0 + root, power);
    }
    for (Eigen::Index i = 0; i < step_.size(); ++i)
        step_[i] = (i == 0 ? 1.0 : step_[i - 1]) / root;
}

const Eigen::VectorXd &LowDiscrepancy::next()
{
    for (Eigen::Index i = 0; i < point_.size(); ++i)
    {
        point_[i] += step_[i];
        if (point_[i] >= 1.0)
            point_[i] -= 1.0;
    }
    return point_;
}
}  // namespace narrows
