// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// A convex polygon of tangents around a superellipse, for geometry libraries that know polygons only.
/// \param tolerance > 0: how far a vertex may be from the superellipse, as a part of the smaller half extent.
Polygon circumscribedPolygon(const Superellipse &shape, double tolerance);
}  // namespace narrows
