// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarArm.h"

namespace narrows
{
/// Derivative of the tip of `link` with respect to the configuration (absolute angles, slide first): 2 x dimension.
void tipJacobian(const PlanarArm &arm, ConfigurationRef q, int link, Eigen::Matrix2Xd &jacobian);
}  // namespace narrows
