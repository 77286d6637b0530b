// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace narrows
{
/// Points that fill the unit cube evenly: the additive recurrence offset + i (g^-1, g^-2, ..., g^-d) modulo 1, with g
/// the positive root of g^(d + 1) = g + 1 (the golden ratio for d = 1).
class LowDiscrepancy
{
public:
    /// \param offset the point before the first, in [0, 1)^d, d >= 1: what makes two sequences differ
    explicit LowDiscrepancy(const Eigen::VectorXd &offset);

    /// The next point, in [0, 1)^d; valid until the next call.
    const Eigen::VectorXd &next();

private:
    Eigen::VectorXd point_, step_;
};
}  // namespace narrows
