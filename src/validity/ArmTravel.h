// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// How far an arm's clearance can change while its joints stay near where they are.
class ArmTravel
{
public:
    /// \param space is read here only
    /// \param selfCollision whether links must keep away from each other: both may move then
    /// \throws std::invalid_argument for spaces of other robots than planar and spatial arms
    ArmTravel(const ArmStateSpace &space, bool selfCollision);

    /// A bound on the change of clearance when every value of the configuration changes by at most as much as given
    /// (all >= 0), in whatever direction.
    double operator()(const Eigen::VectorXd &changes) const { return factor_ * bound_(changes); }

    /// Length of the stretched arm, to tell small clearances from rounding.
    double reach() const { return reach_; }

private:
    double factor_;
    double reach_;
    std::function<double(const Eigen::VectorXd &)> bound_;
};
}  // namespace narrows
