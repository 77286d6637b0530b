// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/MazeGrid.h"

#include <deque>
#include <optional>

namespace narrows
{
namespace
{
constexpr std::array<MazeGrid::Side, 4> sides = {MazeGrid::Right, MazeGrid::Up, MazeGrid::Left, MazeGrid::Down};

MazeGrid::Cell neighbour(MazeGrid::Cell cell, MazeGrid::Side side)
{
    constexpr std::array<MazeGrid::Cell, 4> steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return {cell.x + steps[side].x, cell.y + steps[side].y};
}

MazeGrid::Side opposite(MazeGrid::Side side)
{
    return sides[(side + 2) % 4];
}

template <class Item>
Item pick(const std::vector<Item> &items, RandomNumbers &random)
{
    return items[static_cast<std::size_t>(random.whole(0, static_cast<int>(items.size()) - 1))];
}
}  // namespace

MazeGrid::MazeGrid(int columns, int rows)
  : columns_(columns), rows_(rows), doors_(static_cast<std::size_t>(columns * rows))
{
}

void MazeGrid::open(Cell cell, Side side)
{
    doors_[index(cell)][side] = true;
    doors_[index(neighbour(cell, side))][opposite(side)] = true;
}

std::vector<MazeGrid::Side> MazeGrid::closedSides(Cell cell) const
{
    std::vector<Side> closed;
    for (const Side side : sides)
        if (!isOpen(cell, side) && inside(neighbour(cell, side)))
            closed.push_back(side);
    return closed;
}

void MazeGrid::carve(RandomNumbers &random)
{
    std::vector<bool> seen(doors_.size());
    std::vector<Cell> trail{{0, 0}};
    seen[0] = true;
    while (!trail.empty())
    {
        const Cell cell = trail.back();
        std::vector<Side> fresh;
        for (const Side side : closedSides(cell))
            if (!seen[index(neighbour(cell, side))])
                fresh.push_back(side);
        if (fresh.empty())
        {
            trail.pop_back();
            continue;
        }
        const Side side = pick(fresh, random);
        open(cell, side);
        trail.push_back(neighbour(cell, side));
        seen[index(trail.back())] = true;
    }
}

void MazeGrid::braid(double share, RandomNumbers &random)
{
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x)
        {
            int doors = 0;
            for (const bool open : doors_[index({x, y})])
                doors += open ? 1 : 0;
            const std::vector<Side> closed = closedSides({x, y});
            if (doors == 1 && !closed.empty() && random.uniform(0.0, 1.0) < share)
                open({x, y}, pick(closed, random));
        }
}

std::vector<MazeGrid::Cell> MazeGrid::way() const
{
    // From the last cell outwards: what leads back to it is then in order from the first cell on.
    const Cell last{columns_ - 1, rows_ - 1};
    std::vector<std::optional<Side>> towards(doors_.size());
    std::deque<Cell> front{last};
    while (!front.empty())
    {
        const Cell cell = front.front();
        front.pop_front();
        for (const Side side : sides)
        {
            const Cell to = neighbour(cell, side);
            if (!isOpen(cell, side) || towards[index(to)] || index(to) == index(last))
                continue;
            towards[index(to)] = opposite(side);
            front.push_back(to);
        }
    }
    std::vector<Cell> cells{{0, 0}};
    while (index(cells.back()) != index(last))
        cells.push_back(neighbour(cells.back(), *towards[index(cells.back())]));
    return cells;
}
}  // namespace narrows
