// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// Values of a space's joints beside configurations: what limits of speed are meant for, and what trajectories count.
/// The map between the two is linear. Values of joints that wrap go on beyond pi here, so that motions are continuous.
class JointCoordinates
{
public:
    explicit JointCoordinates(const ArmStateSpace &space);  ///< of a space that outlives this

    Eigen::Index joints() const { return toConfiguration_.rows(); }  ///< how many there are
    /// The configuration at values q is toConfiguration() * q.
    const Eigen::MatrixXd &toConfiguration() const { return toConfiguration_; }
    /// The values q at which the configuration is this one.
    Eigen::VectorXd fromConfiguration(ConfigurationRef configuration) const { return inverse_ * configuration; }

    /// A path's waypoints without wrapping, one column each: joint values for a trajectory.
    Eigen::MatrixXd along(const og::PathGeometric &path) const;

    /// The state at joint values, wrapped where joints wrap.
    void toState(const Eigen::VectorXd &values, ob::State *state) const;

private:
    const ArmStateSpace &space_;
    Eigen::MatrixXd toConfiguration_, inverse_;
};
}  // namespace narrows
