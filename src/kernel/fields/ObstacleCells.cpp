// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/ObstacleCells.h"

#include "kernel/MeshGeometry.h"
#include "kernel/SegmentDistance.h"
#include "kernel/SpatialBounds.h"
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

/// Of the cells in a row along an axis: from the first center at or above `lower` to before the first above `upper`.
std::pair<int, int> cellsBetween(const VoxelGrid<3> &grid, int axis, double lower, double upper)
{
    const auto place = [&](double x)
    {
        return (x - grid.lower()[axis]) / grid.spacing() - 0.5;
    };
    const double most = grid.counts()[axis];
    return {static_cast<int>(std::clamp(std::ceil(place(lower)), 0.0, most)),
            static_cast<int>(std::clamp(std::floor(place(upper)) + 1.0, 0.0, most))};
}

/// Row by row, a rounded box along the axes: less than a fiftieth of the time of blocks (700 boxes, 0.2 to 8 M cells).
void occupyAround(VoxelGrid<3> &grid, const SpatialBounds &box, double room)
{
    const auto [firstZ, endZ] = cellsBetween(grid, 2, box.lower.z() - room, box.upper.z() + room);
    const auto [firstY, endY] = cellsBetween(grid, 1, box.lower.y() - room, box.upper.y() + room);
    for (int k = firstZ; k < endZ; ++k)
        for (int j = firstY; j < endY; ++j)
        {
            const Eigen::Vector3d center = grid.center(VoxelGrid<3>::Index(0, j, k));
            const Eigen::Vector3d away = (box.lower - center).cwiseMax(center - box.upper).cwiseMax(0.0);
            const double square = room * room - away.y() * away.y() - away.z() * away.z();
            if (square < 0.0)
                continue;
            const double reach = std::sqrt(square);
            const auto [first, end] = cellsBetween(grid, 0, box.lower.x() - reach, box.upper.x() + reach);
            const int row = grid.cell(VoxelGrid<3>::Index(0, j, k));
            for (int i = first; i < end; ++i)
                grid.occupy(row + i);
        }
}

struct SpatialFill
{
    void operator()(const Box &box) const
    {
        if (box.pose.linear().isIdentity(0.0))
            occupyAround(grid, spatialBounds(box), room);
        else
            occupySolid(box);
    }

    template <class Shape>
    void operator()(const Shape &shape) const
    {
        occupySolid(shape);
    }

    template <class Shape>
    void occupySolid(const Shape &shape) const
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
