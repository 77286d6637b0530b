// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarObstacle.h"
#include "validity/SupportDistance.h"

namespace narrows
{
/// Convex sets that stand for an obstacle in the verifier: the obstacle itself or, for a polygon that is not convex,
/// its edges. An arm that keeps away from them keeps away from the obstacle, provided that its base is not enclosed.
std::vector<ConvexSet> convexSets(const PlanarObstacle &obstacle);

/// Whether a polygon has the point inside. Always false for other shapes; on the boundary, either answer.
bool polygonEncloses(const PlanarObstacle &obstacle, const Eigen::Vector2d &point);
}  // namespace narrows
