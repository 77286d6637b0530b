// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// What lies around a grid, for the distance of its cells.
enum class GridBorder
{
    Open,  ///< nothing
    Wall,  ///< one more layer of occupied cells on every side
};

/// For every cell the squared distance between its center and the nearest center of an occupied cell, in cells: a whole
/// number, exact. 0 in occupied cells; noSquaredDistance everywhere if there is nothing occupied.
///
/// One lower envelope of parabolas per row and axis (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled
/// Functions, 2012), in integers: the work is linear in the cells.
/// \pre the squared diagonal of the grid in cells is less than 2^31 - 1
template <int D>
std::vector<int> squaredDistances(const VoxelGrid<D> &grid, GridBorder border);

constexpr int noSquaredDistance = std::numeric_limits<int>::max();  ///< where no cell is occupied

/// How far every cell's center is from the nearest occupied one, in units of length; infinity where there is none.
///
/// If the cells were occupied within `room` >= half a cell's diagonal of a set of obstacles, the true distance from
/// that set, for any center outside of it, is between this minus half a diagonal and this plus `room` (the latter where
/// the nearest occupied cell is not of the border).
template <int D>
std::vector<float> distanceField(const VoxelGrid<D> &grid, GridBorder border);

extern template std::vector<int> squaredDistances(const VoxelGrid<2> &, GridBorder);
extern template std::vector<int> squaredDistances(const VoxelGrid<3> &, GridBorder);
extern template std::vector<float> distanceField(const VoxelGrid<2> &, GridBorder);
extern template std::vector<float> distanceField(const VoxelGrid<3> &, GridBorder);
}  // namespace narrows
