// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "scenario/families/RandomNumbers.h"

namespace narrows
{
/// Cells in columns and rows, and the doors between neighbours. All doors are closed at first.
class MazeGrid
{
public:
    enum Side
    {
        Right,
        Up,
        Left,
        Down
    };

    struct Cell
    {
        int x;
        int y;
    };

    MazeGrid(int columns, int rows);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool isOpen(Cell cell, Side side) const { return doors_[index(cell)][side]; }

    /// Opens doors until there is one way between any two cells: a random walk that steps back from dead ends.
    void carve(RandomNumbers &random);

    /// Opens a second door of a dead end, for that share of them.
    void braid(double share, RandomNumbers &random);

    /// Cells of a shortest way from the first cell to the last one, both included. \pre there is one
    std::vector<Cell> way() const;

private:
    std::size_t index(Cell cell) const { return static_cast<std::size_t>(cell.y * columns_ + cell.x); }
    bool inside(Cell cell) const { return cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_; }
    void open(Cell cell, Side side);
    /// Sides of a cell with a neighbour and a closed door.
    std::vector<Side> closedSides(Cell cell) const;

    int columns_;
    int rows_;
    std::vector<std::array<bool, 4>> doors_;  ///< by cell, then by side
};
}  // namespace narrows
