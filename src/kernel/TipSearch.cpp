// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/TipSearch.h"

namespace narrows
{
Eigen::VectorXd jointUnits(const SpatialArm &arm)
{
    Eigen::VectorXd units(arm.dimension());
    for (int i = 0; i < arm.dimension(); ++i)
        units[i] = arm.joints()[i].kind == SpatialJoint::Kind::Revolute ? 1.0 : arm.reach();
    return units;
}
}  // namespace narrows
