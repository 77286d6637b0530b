// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ConvexSets.h"

#include <algorithm>
#include <utility>

namespace narrows::proof
{
namespace
{
using Eigen::Vector2d;

double cross(const Vector2d &a, const Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

const Vector2d &vertexAfter(const Polygon &polygon, std::size_t i)
{
    return polygon.vertices[(i + 1) % polygon.vertices.size()];
}

bool isConvex(const Polygon &polygon)
{
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
    {
        const Vector2d &corner = vertexAfter(polygon, i);
        if (cross(corner - polygon.vertices[i], vertexAfter(polygon, i + 1) - corner) < 0.0)
            return false;
    }
    return true;
}

ConvexSet<2> hull(const Hull &points)
{
    Vector2d center = Vector2d::Zero();
    for (const Vector2d &point : points)
        center += point / static_cast<double>(points.size());
    double radius = 0.0;
    for (const Vector2d &point : points)
        radius = std::max(radius, (point - center).norm());
    return {points, 0.0, center, radius};
}

struct SetsOf
{
    std::vector<ConvexSet<2>> operator()(const Circle &circle) const
    {
        return {{Segment<2>{circle.center, circle.center}, circle.radius, circle.center, 0.0}};
    }

    std::vector<ConvexSet<2>> operator()(const Superellipse &shape) const
    {
        return {{shape, 0.0, shape.center, shape.halfExtents.norm()}};
    }

    std::vector<ConvexSet<2>> operator()(const Polygon &polygon) const
    {
        if (isConvex(polygon))
            return {hull(polygon.vertices)};
        std::vector<ConvexSet<2>> edges;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
            edges.push_back(hull({polygon.vertices[i], vertexAfter(polygon, i)}));
        return edges;
    }
};
}  // namespace

Parts<2> partsOf(const std::vector<PlanarObstacle> &obstacles, double /*extent*/)
{
    Parts<2> parts;
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        for (ConvexSet<2> &set : std::visit(SetsOf{}, obstacles[i].shape))
            parts.add(std::move(set), static_cast<int>(i));
    return parts;
}

bool encloses(const PlanarObstacle &obstacle, const Vector2d &point)
{
    const auto *polygon = std::get_if<Polygon>(&obstacle.shape);
    if (!polygon)
        return false;
    bool inside = false;  // even-odd rule along the ray to the right
    for (std::size_t i = 0; i < polygon->vertices.size(); ++i)
    {
        const Vector2d from = polygon->vertices[i] - point, to = vertexAfter(*polygon, i) - point;
        if ((from.y() > 0.0) != (to.y() > 0.0) && (cross(from, to) > 0.0) == (to.y() > from.y()))
            inside = !inside;
    }
    return inside;
}
}  // namespace narrows::proof
