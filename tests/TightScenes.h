// SPDX-License-Identifier: BSD-3-Clause
// Grids of the tight-maneuvering benchmarks: the U-turn with a thin wall, the pipe with thirteen right-angle bends, and
// clutter.
#pragma once

#include "kernel/fields/ObstacleCells.h"

namespace narrows
{
/// Axis-parallel boxes of the plane or of space.
template <int D>
struct OpenBox
{
    Eigen::Matrix<double, D, 1> lower;
    Eigen::Matrix<double, D, 1> upper;
};

/// Free cells are those whose centers lie in one of the open boxes.
template <int D>
VoxelGrid<D> gridOfRooms(const Eigen::Matrix<double, D, 1> &lower, const Eigen::Matrix<double, D, 1> &upper,
                         double spacing, const std::vector<OpenBox<D>> &rooms)
{
    VoxelGrid<D> grid = VoxelGrid<D>::make(lower, upper, spacing).grid;
    for (int cell = 0; cell < grid.cells(); ++cell)
    {
        const auto center = grid.center(cell);
        if (std::none_of(rooms.begin(), rooms.end(),
                         [&](const OpenBox<D> &room) {
                             return (center.array() > room.lower.array()).all() &&
                                    (center.array() < room.upper.array()).all();
                         }))
            grid.occupy(cell);
    }
    return grid;
}

/// Two legs 200 wide, joined at the top, with a wall of 40 between them; from (100, 50) to (340, 50).
inline VoxelGrid<2> uTurn(double spacing)
{
    return gridOfRooms<2>(
        {0.0, 0.0}, {440.0, 1100.0}, spacing,
        {{{0.0, 0.0}, {200.0, 1100.0}}, {{240.0, 0.0}, {440.0, 1100.0}}, {{0.0, 900.0}, {440.0, 1100.0}}});
}

/// Centre line of a square duct, 40 wide, with thirteen right-angle bends; the goal is at its back().
inline std::vector<Eigen::Vector3d> bentPipeLine()
{
    return {{40, 240, 60},   {320, 240, 60},  {320, 240, 300}, {320, 420, 300}, {440, 420, 300},
            {440, 420, 100}, {440, 180, 100}, {560, 180, 100}, {560, 180, 400}, {560, 60, 400},
            {680, 60, 400},  {680, 60, 140},  {680, 300, 140}, {800, 300, 140}, {800, 300, 400}};
}

/// That duct and a room up to x = 240 before it.
/// \param from where the room begins, 0 in the benchmark
inline VoxelGrid<3> bentPipe(double spacing, double from = 0.0)
{
    const std::vector<Eigen::Vector3d> line = bentPipeLine();
    std::vector<OpenBox<3>> rooms{{{from, 0.0, 0.0}, {240.0, 480.0, 480.0}}};
    for (std::size_t i = 1; i < line.size(); ++i)
        rooms.push_back({line[i - 1].cwiseMin(line[i]).array() - 20.0, line[i - 1].cwiseMax(line[i]).array() + 20.0});
    return gridOfRooms<3>({from, 0.0, 0.0}, {860.0, 480.0, 480.0}, spacing, rooms);
}

/// `count` axis-parallel boxes in 800 x 480 x 480, none before x = 150 nor within 25 of (760, 100, 380).
inline std::vector<SpatialObstacle> clutter(int count)
{
    std::uint64_t state = 7;
    const auto next = [&state]
    {
        state = state * 48271 % 2147483647;
        return static_cast<double>(state) / 2147483647.0;
    };
    for (int i = 0; i < 200; ++i)
        next();
    const Eigen::Vector3d goal(760.0, 100.0, 380.0);
    std::vector<SpatialObstacle> boxes;
    while (static_cast<int>(boxes.size()) < count)
    {
        Eigen::Vector3d half, center;
        for (double &size : half)
            size = 12.0 + 24.0 * next();
        center.x() = 160.0 + 640.0 * next();
        center.y() = 480.0 * next();
        center.z() = 480.0 * next();
        const Eigen::Vector3d lower = (center - half).array().floor(), upper = (center + half).array().ceil();
        const Eigen::Vector3d away = (lower - goal).cwiseMax(goal - upper).cwiseMax(0.0);
        if (lower.x() < 150.0 || away.norm() < 25.0)
            continue;
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() = 0.5 * (lower + upper);
        boxes.push_back({"box" + std::to_string(boxes.size()), Box{pose, 0.5 * (upper - lower)}});
    }
    return boxes;
}

inline VoxelGrid<3> clutterGrid(int count, double spacing, double room)
{
    VoxelGrid<3> grid = VoxelGrid<3>::make({0.0, 0.0, 0.0}, {800.0, 480.0, 480.0}, spacing).grid;
    occupyCells(grid, clutter(count), room);
    return grid;
}
}  // namespace narrows
