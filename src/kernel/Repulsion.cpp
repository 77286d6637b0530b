// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/Repulsion.h"

#include <cmath>
#include <stdexcept>

namespace narrows
{
void requireStrengths(const std::vector<double> &strengths, std::size_t count, const std::string &what)
{
    if (strengths.size() != count)
        throw std::invalid_argument("there must be one repulsion per " + what);
    for (const double strength : strengths)
        if (!std::isfinite(strength))
            throw std::invalid_argument("a repulsion must be finite");
}

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
