// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarObstacle.h"

namespace narrows
{
namespace
{
struct BoundsOf
{
    Bounds operator()(const Circle &circle) const
    {
        const Eigen::Vector2d extent = Eigen::Vector2d::Constant(circle.radius);
        return {circle.center - extent, circle.center + extent};
    }

    Bounds operator()(const Superellipse &shape) const
    {
        return {shape.center - shape.halfExtents, shape.center + shape.halfExtents};
    }

    Bounds operator()(const Polygon &polygon) const
    {
        Bounds box{polygon.vertices.front(), polygon.vertices.front()};
        for (const Eigen::Vector2d &vertex : polygon.vertices)
        {
            box.lower = box.lower.cwiseMin(vertex);
            box.upper = box.upper.cwiseMax(vertex);
        }
        return box;
    }
};
}  // namespace

Bounds bounds(const PlanarObstacle &obstacle)
{
    return std::visit(BoundsOf{}, obstacle.shape);
}
}  // namespace narrows
