// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/JointCoordinates.h"

#include <ompl/base/ScopedState.h>
#include <Eigen/LU>

namespace narrows
{
JointCoordinates::JointCoordinates(const ArmStateSpace &space) : space_(space)
{
    const Eigen::Index joints = static_cast<Eigen::Index>(space.getDimension());
    toConfiguration_.resize(joints, joints);
    ob::State *state = space.allocState();
    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    Eigen::VectorXd column;
    for (Eigen::Index i = 0; i < joints; ++i)
    {
        std::fill(values, values + joints, 0.0);
        values[i] = 1.0;
        space.toConfiguration(state, column);
        toConfiguration_.col(i) = column;
    }
    space.freeState(state);
    inverse_ = toConfiguration_.inverse();
}

Eigen::MatrixXd JointCoordinates::along(const og::PathGeometric &path) const
{
    const std::vector<Eigen::VectorXd> rows = space_.unwrap(path);
    Eigen::MatrixXd values(joints(), static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        values.col(static_cast<Eigen::Index>(i)) = fromConfiguration(rows[i]);
    return values;
}

void JointCoordinates::toState(const Eigen::VectorXd &values, ob::State *state) const
{
    space_.fromConfiguration(toConfiguration_ * values, state);
}
}  // namespace narrows
