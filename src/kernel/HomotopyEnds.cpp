// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/HomotopyEnds.h"

#include <stdexcept>

namespace narrows
{
HomotopyEnds::HomotopyEnds(const std::vector<std::shared_ptr<const Repulsion>> &repulsions, const Eigen::VectorXd &from,
                           const Eigen::VectorXd &to)
  : start(from), goal(to)
{
    if (repulsions.empty())
        throw std::invalid_argument("a homotopy needs a repulsion");
    const auto count = static_cast<Eigen::Index>(repulsions.size());
    startValues.resize(count);
    goalValues.resize(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
        if (repulsions[i] == nullptr)
            throw std::invalid_argument("a repulsion is missing");
        const int n = repulsions[i]->dimension();
        if (start.size() != n || goal.size() != n || !start.allFinite() || !goal.allFinite())
            throw std::invalid_argument("start and goal must be finite configurations of the robot");
        startValues[i] = repulsions[i]->value(start);
        goalValues[i] = repulsions[i]->value(goal);
    }
    if (!startValues.allFinite() || !goalValues.allFinite())
        throw std::invalid_argument("start or goal lies on a pole");
    difference = goal - start;
}
}  // namespace narrows
