// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Cuts a simple polygon into convex ones (counter-clockwise, no new vertices) whose union it is; at most four times as
/// many as necessary. A convex polygon comes back as it is.
/// \throws std::invalid_argument if the polygon has fewer than three vertices or crosses itself.
std::vector<Polygon> convexPieces(const Polygon &polygon);
}  // namespace narrows
