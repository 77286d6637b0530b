// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Convex polygons that do not overlap and together are the polygon: itself if it is convex, else triangles.
std::vector<Polygon> convexParts(const Polygon &polygon);
}  // namespace narrows
