// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/HomotopyWords.h"

namespace narrows
{
namespace
{
using Index = VoxelGrid<2>::Index;

bool atBorder(const VoxelGrid<2> &grid, const Index &index)
{
    return (index.array() == 0).any() || (index.array() + 1 == grid.counts().array()).any();
}

/// Marks all that hangs together with an occupied cell. \return whether it reaches the border
bool markIsland(const VoxelGrid<2> &grid, int first, std::vector<char> &seen)
{
    bool border = false;
    std::vector<int> pending{first};
    seen[first] = 1;
    while (!pending.empty())
    {
        const Index index = grid.index(pending.back());
        pending.pop_back();
        border = border || atBorder(grid, index);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
            {
                const Index next = index + Index(dx, dy);
                if (!grid.contains(next) || grid.free(next) || seen[grid.cell(next)])
                    continue;
                seen[grid.cell(next)] = 1;
                pending.push_back(grid.cell(next));
            }
    }
    return border;
}

void append(std::vector<int> &word, int letter)
{
    if (!word.empty() && word.back() == -letter)
        word.pop_back();
    else
        word.push_back(letter);
}
}  // namespace

HomotopyWords::HomotopyWords(const VoxelGrid<2> &grid) : grid_(grid), rays_(grid.counts().x())
{
    std::vector<char> seen(grid.cells(), 0);
    for (int cell = 0; cell < grid.cells(); ++cell)
    {
        if (!grid.occupied(cell) || seen[cell] || markIsland(grid, cell, seen))
            continue;
        const Index index = grid.index(cell);
        rays_[index.x()].push_back({++islands_, index.y()});
    }
}

std::vector<int> HomotopyWords::word(const std::vector<int> &cells) const
{
    // A ray stands between its cell's column and the next one. Rays of one column stand side by side there, in the
    // order of their letters.
    std::vector<int> word;
    for (std::size_t i = 1; i < cells.size(); ++i)
    {
        const Index from = grid_.index(cells[i - 1]), to = grid_.index(cells[i]);
        if (to.x() > from.x())
            for (const Ray &ray : rays_[from.x()])
            {
                if (ray.row < from.y())
                    append(word, ray.letter);
            }
        else if (to.x() < from.x())
        {
            const std::vector<Ray> &rays = rays_[to.x()];
            for (auto ray = rays.rbegin(); ray != rays.rend(); ++ray)
                if (ray->row < from.y())
                    append(word, -ray->letter);
        }
    }
    return word;
}
}  // namespace narrows
