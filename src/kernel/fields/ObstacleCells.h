// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarObstacle.h"
#include "kernel/SpatialModel.h"
#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Occupies the cells whose centers are at most `room` (>= 0) from an obstacle.
///
/// With room >= half the diagonal of a cell no obstacle, however thin, slips between the centers: every cell that an
/// obstacle meets is occupied.
/// \throws std::invalid_argument for a mesh that MeshGeometry refuses
///@{
void occupyCells(VoxelGrid<2> &grid, const std::vector<PlanarObstacle> &obstacles, double room);
void occupyCells(VoxelGrid<3> &grid, const std::vector<SpatialObstacle> &obstacles, double room);
///@}
}  // namespace narrows
