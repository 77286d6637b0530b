// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Where a path may go from a cell.
enum class CellSteps
{
    Faces,  ///< to the 4 or 6 cells next to it
    All,    ///< to the 8 or 26 around it, if all cells that the two have around them are free: no corner is cut
};

/// From a cell to one beside it.
template <int D>
struct CellStep
{
    Eigen::Matrix<int, D, 1> offset;  ///< in cells along the axes, each -1, 0 or 1
    int jump;                         ///< the same as a difference of cells
    double length;                    ///< in units of length
    std::vector<int> between;         ///< jumps to the cells that must be free too
};

/// All steps of a kind from a cell inside the grid.
template <int D>
std::vector<CellStep<D>> stepsOf(const VoxelGrid<D> &grid, CellSteps steps)
{
    using Index = Eigen::Matrix<int, D, 1>;
    const int codes = D == 2 ? 9 : 27;
    std::vector<Index> offsets;
    for (int code = 0; code < codes; ++code)
    {
        Index offset;
        for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3)
            offset[axis] = rest % 3 - 1;
        offsets.push_back(offset);
    }
    std::vector<CellStep<D>> result;
    for (const Index &offset : offsets)
    {
        const int moved = offset.cwiseAbs().sum();
        if (moved == 0 || (moved > 1 && steps == CellSteps::Faces))
            continue;
        CellStep<D> step{offset, grid.cell(offset), grid.spacing() * std::sqrt(static_cast<double>(moved)), {}};
        for (const Index &part : offsets)
        {
            // A part of the step: along some of its axes, in its direction.
            const bool isPart = ((part.array() == 0) || (part.array() == offset.array())).all();
            if (isPart && part != offset && !part.isZero())
                step.between.push_back(grid.cell(part));
        }
        result.push_back(step);
    }
    return result;
}
}  // namespace narrows
