// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Whether a shape covers a whole disc. True is always right; false may be said of a superellipse that covers it
/// barely.
/// \param radius >= 0
bool coversDisc(const PlanarObstacle &obstacle, const Eigen::Vector2d &center, double radius);
}  // namespace narrows
