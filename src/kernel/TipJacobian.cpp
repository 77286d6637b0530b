// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/TipJacobian.h"

#include <cmath>

namespace narrows
{
void tipJacobian(const PlanarArm &arm, ConfigurationRef q, int link, Eigen::Matrix2Xd &jacobian)
{
    jacobian.setZero(2, arm.dimension());
    if (arm.slide())
        jacobian.col(0) = arm.slide()->axis;
    for (int i = link; i >= 0; i = arm.links()[i].parent)
    {
        const double angle = q[arm.firstAngle() + i];
        jacobian.col(arm.firstAngle() + i) = arm.links()[i].length * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
    }
}

void tipJacobian(const SpatialArm &arm, const SpatialArm::Placement &placement, int link, Eigen::Matrix3Xd &jacobian)
{
    jacobian.resize(3, arm.dimension());
    Eigen::VectorXd gradient(arm.dimension());
    for (int axis = 0; axis < 3; ++axis)
    {
        gradient.setZero();
        arm.addGradient(placement, link, placement.points[2 * link + 1], Eigen::Vector3d::Unit(axis), gradient);
        jacobian.row(axis) = gradient.transpose();
    }
}
}  // namespace narrows
