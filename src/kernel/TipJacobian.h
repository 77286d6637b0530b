// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarArm.h"
#include "kernel/SpatialArm.h"

namespace narrows
{
/// Derivative of the tip of `link` with respect to the configuration (absolute angles, slide first): 2 x dimension.
void tipJacobian(const PlanarArm &arm, ConfigurationRef q, int link, Eigen::Matrix2Xd &jacobian);

/// Derivative of the end of `link` with respect to the configuration: 3 x dimension.
void tipJacobian(const SpatialArm &arm, const SpatialArm::Placement &placement, int link, Eigen::Matrix3Xd &jacobian);
}  // namespace narrows
