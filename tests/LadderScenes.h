// SPDX-License-Identifier: BSD-3-Clause
// The planar scenes of tight maneuvering as walls, with what the kernel asks of them.
#pragma once

#include "kernel/PlanarObstacle.h"
#include "kernel/fields/CorridorPath.h"
#include "kernel/fields/DistanceField.h"
#include "kernel/fields/ObstacleCells.h"
#include "kernel/fields/PathWindow.h"
#include "scenario/families/Family.h"

namespace narrows
{
inline ChainScene<2> ladderScene(const std::string &shape, double length = 350.0)
{
    const Family &family = findFamily("ladder");
    return std::get<ChainScene<2>>(family.draw(family.values({{"shape", shape}, {"length", std::to_string(length)}})));
}

inline std::vector<PlanarObstacle> obstaclesOf(const std::vector<AxisBox<2>> &walls)
{
    std::vector<PlanarObstacle> obstacles;
    for (const AxisBox<2> &wall : walls)
        obstacles.push_back(
            {"W" + std::to_string(obstacles.size() + 1),
             Polygon{{wall.lower, {wall.upper.x(), wall.lower.y()}, wall.upper, {wall.lower.x(), wall.upper.y()}}}});
    return obstacles;
}

/// The cheapest corridor on a grid of 10, windowed.
inline PointPath<2> middleOf(const ChainScene<2> &scene)
{
    AxisBox<2> bounds = boundsOf(scene.walls);
    bounds.lower.y() = 0.0;  // not around outside
    VoxelGrid<2> grid = VoxelGrid<2>::make(bounds.lower, bounds.upper, 10.0).grid;
    occupyCells(grid, obstaclesOf(scene.walls), 5.0);
    const std::vector<float> clearance = distanceField(grid, GridBorder::Wall);
    const PointPath<2> path = findCorridor<2>(grid, clearance, scene.entrance, scene.goal).path;
    return windowed<2>(resampled<2>(path, 10.0), 5, 3);
}
}  // namespace narrows
