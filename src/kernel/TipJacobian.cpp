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
    const Eigen::Vector3d &point = placement.points[2 * link + 1];
    jacobian.setZero(3, arm.dimension());
    for (int i = arm.links()[link].joint; i >= 0; i = arm.joints()[i].parent)
    {
        const SpatialJoint &joint = arm.joints()[i];
        const Eigen::Isometry3d &frame = placement.frames[i];
        const Eigen::Vector3d axis = frame.linear() * joint.axis;
        if (joint.kind == SpatialJoint::Kind::Prismatic)
            jacobian.col(i) = axis;
        else
            jacobian.col(i) = axis.cross(point - frame.translation());
    }
}
}  // namespace narrows
