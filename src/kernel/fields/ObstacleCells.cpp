// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/ObstacleCells.h"

#include "kernel/MeshGeometry.h"
#include "kernel/SegmentDistance.h"
#include "kernel/SpatialDistance.h"
#include "kernel/SuperellipseGeometry.h"

namespace narrows
{
namespace
{
struct PlanarFill
{
    void operator()(const Circle &circle) const
    {
        grid.occupyWithin(
            [&circle](const Eigen::Vector2d &point) { return (point - circle.center).norm() - circle.radius; }, room);
    }

    void operator()(const Superellipse &shape) const
    {
        const SuperellipseGeometry geometry(shape);
        grid.occupyWithin([&geometry](const Eigen::Vector2d &point) { return geometry.distance(point, point); }, room);
    }

    void operator()(const Polygon &polygon) const
    {
        const std::vector<Eigen::Vector2d> &corners = polygon.vertices;
        grid.occupyWithin(
            [&](const Eigen::Vector2d &point)
            {
                double square = (point - corners[0]).squaredNorm();
                for (std::size_t i = 0; i < corners.size(); ++i)
                    square = std::min(square, squaredDistance(corners[i], corners[(i + 1) % corners.size()], point));
                return narrows::contains(polygon, point) ? -std::sqrt(square) : std::sqrt(square);
            },
            room);
    }

    VoxelGrid<2> &grid;
    double room;
};

struct SpatialFill
{
    template <class Shape>
    void operator()(const Shape &shape) const
    {
        grid.occupyWithin([&shape](const Eigen::Vector3d &point) { return nearness(point, point, shape).distance; },
                          room);
    }

    void operator()(const Mesh &mesh) const
    {
        const MeshGeometry geometry(mesh);
        int guess = 0;
        grid.occupyWithin([&](const Eigen::Vector3d &point) { return geometry.nearest(point, point, &guess).distance; },
                          room);
    }

    VoxelGrid<3> &grid;
    double room;
};
}  // namespace

void occupyCells(VoxelGrid<2> &grid, const std::vector<PlanarObstacle> &obstacles, double room)
{
    for (const PlanarObstacle &obstacle : obstacles)
        std::visit(PlanarFill{grid, room}, obstacle.shape);
}

void occupyCells(VoxelGrid<3> &grid, const std::vector<SpatialObstacle> &obstacles, double room)
{
    for (const SpatialObstacle &obstacle : obstacles)
        std::visit(SpatialFill{grid, room}, obstacle.shape);
}
}  // namespace narrows
