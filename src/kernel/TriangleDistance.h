// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kernel/SpatialDistance.h"

namespace narrows
{
/// Its corners.
using Triangle = std::array<Eigen::Vector3d, 3>;

/// A triangle has no inside: where the segment passes through it, `distance` is minus the way back out of it for the
/// nearer end, and `point` that end. A segment that passes within 1e-12 of the triangle's size passes through it.
/// \param edges which edges count, bit i for the one from corner i to the next. In a mesh one of both triangles of an
/// edge is enough. If nothing is left that could be nearest, the distance is infinite.
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Triangle &triangle, unsigned edges = 7);
}  // namespace narrows
