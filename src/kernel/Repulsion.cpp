// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/Repulsion.h"

namespace narrows
{
Surroundings RepulsionModel::surroundings(const Eigen::Ref<const Eigen::VectorXd> &q, double /*throat*/) const
{
    const std::size_t count = groups().size();
    Surroundings result;
    Eigen::VectorXd gradient;
    result.clearance = clearance(q, gradient);
    result.sides.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
        std::vector<double> strengths(count, 0.0);
        strengths[i] = 1.0;
        result.weights.push_back(continuous(strengths)->value(q));
    }
    return result;
}
}  // namespace narrows
