// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/SpatialShape.h"

#include <algorithm>
#include <limits>

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Half the least breadth of a convex polygon: it is across one of its edges.
double leastHalfBreadthOf(const std::vector<Eigen::Vector2d> &vertices)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        const Eigen::Vector2d edge = (vertices[(i + 1) % vertices.size()] - vertices[i]).normalized();
        double breadth = 0.0;
        for (const Eigen::Vector2d &vertex : vertices)
            breadth = std::max(breadth, edge.x() * (vertex - vertices[i]).y() - edge.y() * (vertex - vertices[i]).x());
        least = std::min(least, 0.5 * breadth);
    }
    return least;
}

/// Of a cylinder: the corners of a square about an end that faces a direction, or the ends of the line that does.
std::vector<Vector3d> cylinderFacing(const Cylinder &cylinder, const Vector3d &direction, double depth)
{
    const double along = cylinder.axis.dot(direction);
    const Vector3d aside = direction - along * cylinder.axis;
    const Vector3d out = aside.norm() > 0.0 ? aside.normalized() : perpendicular(cylinder.axis);
    const Vector3d end = std::copysign(cylinder.halfLength, along) * cylinder.axis;
    const Vector3d radial = cylinder.radius * out, tangent = cylinder.axis.cross(radial);
    if (2.0 * cylinder.radius * aside.norm() <= depth)
        return {cylinder.center + end + radial + tangent, cylinder.center + end + radial - tangent,
                cylinder.center + end - radial - tangent, cylinder.center + end - radial + tangent};
    if (2.0 * cylinder.halfLength * std::abs(along) <= depth)
        return {cylinder.center + radial + end, cylinder.center + radial - end};
    return {cylinder.center + radial + end};
}
}  // namespace

SpatialShape::SpatialShape(const Convex &convex, double far) : convex_(convex)
{
    if (auto *cylinder = std::get_if<Cylinder>(&convex_))
        cylinder->halfLength = std::min(cylinder->halfLength, far);
    if (auto *prism = std::get_if<Prism>(&convex_))
        prism->halfLength = std::min(prism->halfLength, far);
    std::visit(
        [this](const auto &shape)
        {
            box_ = spatialBounds(shape);
            take(shape);
        },
        convex_);
}

void SpatialShape::take(const Sphere &sphere)
{
    edges_ = {{sphere.center, sphere.center}};
    edgeRadius_ = leastHalfBreadth_ = sphere.radius;
}

void SpatialShape::take(const Capsule &capsule)
{
    edges_ = {{capsule.from, capsule.to}};
    edgeRadius_ = leastHalfBreadth_ = capsule.radius;
}

void SpatialShape::take(const Cylinder &cylinder)
{
    const Vector3d half = cylinder.halfLength * cylinder.axis;
    edges_ = {{cylinder.center - half, cylinder.center + half}};
    leastHalfBreadth_ = std::min(cylinder.radius, cylinder.halfLength);
}

void SpatialShape::take(const Box &box)
{
    const Vector3d &half = box.halfExtents;
    for (int axis = 0; axis < 3; ++axis)
        for (const double one : {-1.0, 1.0})
            for (const double other : {-1.0, 1.0})
            {
                Vector3d from;
                from[axis] = -half[axis];
                from[(axis + 1) % 3] = one * half[(axis + 1) % 3];
                from[(axis + 2) % 3] = other * half[(axis + 2) % 3];
                Vector3d to = from;
                to[axis] = half[axis];
                edges_.emplace_back(box.pose * from, box.pose * to);
            }
    leastHalfBreadth_ = half.minCoeff();
}

void SpatialShape::take(const Prism &prism)
{
    const auto corner = [&](std::size_t i, double side) -> Vector3d
    {
        const Eigen::Vector2d &vertex = prism.vertices[i % prism.vertices.size()];
        return prism.pose * Vector3d(vertex.x(), vertex.y(), side * prism.halfLength);
    };
    for (std::size_t i = 0; i < prism.vertices.size(); ++i)
    {
        edges_.emplace_back(corner(i, -1.0), corner(i, 1.0));
        for (const double side : {-1.0, 1.0})
            edges_.emplace_back(corner(i, side), corner(i + 1, side));
    }
    leastHalfBreadth_ = std::min(leastHalfBreadthOf(prism.vertices), prism.halfLength);
}

Nearness SpatialShape::nearest(const Vector3d &a, const Vector3d &b) const
{
    return std::visit([&](const auto &shape) { return nearness(a, b, shape); }, convex_);
}

std::vector<Vector3d> SpatialShape::facing(const Vector3d &direction, double depth) const
{
    if (const auto *cylinder = std::get_if<Cylinder>(&convex_))
        return cylinderFacing(*cylinder, direction, depth);
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Edge &edge : edges_)
        furthest = std::max({furthest, edge.first.dot(direction), edge.second.dot(direction)});
    std::vector<Vector3d> points;
    for (const Edge &edge : edges_)
        for (const Vector3d &end : {edge.first, edge.second})
        {
            const Vector3d point = end + edgeRadius_ * direction;
            // Edges share their ends, exactly.
            if (end.dot(direction) >= furthest - depth &&
                std::find(points.begin(), points.end(), point) == points.end())
                points.push_back(point);
        }
    return points;
}

namespace
{
/// The nearest points of the first shape's edges and the second, if they are nearer than `best`.
void tryEdges(const SpatialShape &first, const SpatialShape &second, bool swapped, SpatialNearestPoints &best)
{
    for (const SpatialShape::Edge &edge : first.edges())
    {
        const Nearness near = second.nearest(edge.first, edge.second);
        const double distance = near.distance - first.edgeRadius();
        if (!(distance < best.distance))
            continue;
        const Vector3d own = near.point - first.edgeRadius() * near.normal, foot = near.foot();
        best = {swapped ? foot : own, swapped ? own : foot, swapped ? near.normal : Vector3d(-near.normal), distance};
    }
}

void project(const SpatialShape &first, const SpatialShape &second, SpatialNearestPoints &best)
{
    constexpr double still = 1e-13;
    constexpr int most = 2000;
    for (int i = 0; i < most && best.distance > 0.0; ++i)
    {
        const Nearness toFirst = first.nearest(best.second, best.second);
        const Vector3d foot = toFirst.foot();
        const Nearness toSecond = second.nearest(foot, foot);
        const double moved = (toSecond.foot() - best.second).norm();
        best = {foot, toSecond.foot(), -toSecond.normal, toSecond.distance};
        if (!(moved > still))
            return;
    }
}
}  // namespace

SpatialNearestPoints nearestPoints(const SpatialShape &first, const SpatialShape &second)
{
    SpatialNearestPoints best{{}, {}, {}, std::numeric_limits<double>::infinity()};
    tryEdges(first, second, false, best);
    tryEdges(second, first, true, best);
    if (best.distance > 0.0 && (first.isCylinder() || second.isCylinder()))
        project(first, second, best);
    return best;
}
}  // namespace narrows
