// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "kernel/Repulsion.h"

namespace narrows
{
/// What every homotopy between two configurations begins with: where it starts and ends, and W there.
struct HomotopyEnds
{
    /// \throws std::invalid_argument if there is no repulsion or one is null, if start or goal is not a finite
    /// configuration of the robot, or if some W is not finite there.
    HomotopyEnds(const std::vector<std::shared_ptr<const Repulsion>> &repulsions, const Eigen::VectorXd &start,
                 const Eigen::VectorXd &goal);

    Eigen::VectorXd start;        ///< where lambda = 0
    Eigen::VectorXd goal;         ///< where lambda = 1
    Eigen::VectorXd difference;   ///< D = goal - start
    Eigen::VectorXd startValues;  ///< W at the start, one per repulsion
    Eigen::VectorXd goalValues;   ///< and at the goal
};
}  // namespace narrows
