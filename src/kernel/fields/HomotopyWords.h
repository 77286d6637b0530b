// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Tells apart on which sides of the islands of occupied cells a path of cells in the plane goes.
///
/// From one cell of each island (cells joined by sides or corners that do not reach the grid's border, which no path
/// can go around) a ray goes up. A path's word lists the rays that it crosses, with the direction; a ray crossed to and
/// fro at once is dropped. Two paths with the same ends can be deformed into each other through free cells exactly if
/// their words are equal.
class HomotopyWords
{
public:
    /// \param grid solids are its occupied cells
    explicit HomotopyWords(const VoxelGrid<2> &grid);

    int islands() const { return islands_; }  ///< solids that do not touch the border

    /// Letters i + 1 for ray i crossed to the right, -(i + 1) for one crossed to the left.
    /// \param cells each a side or a corner away from the one before, no corner of an occupied cell cut
    std::vector<int> word(const std::vector<int> &cells) const;

private:
    struct Ray
    {
        int letter;
        int row;
    };

    const VoxelGrid<2> grid_;
    int islands_ = 0;
    std::vector<std::vector<Ray>> rays_;  ///< by column
};
}  // namespace narrows
