// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialArm.h"

namespace narrows
{
/// Whether these make a `SpatialArm`. \throws std::invalid_argument as said there.
void checkParts(const std::vector<SpatialJoint> &joints, const std::vector<SpatialLink> &links,
                const std::vector<UniversalLimit> &universalLimits);
}  // namespace narrows
