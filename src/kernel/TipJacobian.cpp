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
}  // namespace narrows
