// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialArm.h"

namespace narrows
{
/// SpatialArm::areNeighbours() of all pairs of links, row by row.
/// \param atZero the arm placed at zero
std::vector<bool> findNeighbours(const SpatialArm &arm, const SpatialArm::Placement &atZero);
}  // namespace narrows
