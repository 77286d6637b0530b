// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/threading/SpatialGap.h"
#include "kernel/threading/SpatialShape.h"

namespace narrows
{
/// Gaps that meshes take part in (see findGaps()): where a face looks straight at something, another face or a convex
/// shape, that looks back at less than 45 degrees. Of several that look across nearly the same place in nearly the same
/// direction, the narrowest is kept. Such gaps have no line `along` which they stay narrow.
void addMeshGaps(const std::vector<const Mesh *> &meshes, const std::vector<SpatialShape> &shapes, double thinnest,
                 double widest, std::vector<SpatialGap> &gaps);
}  // namespace narrows
