// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PassingPlanes.h"

#include <array>
#include <cmath>
#include <vector>

#include "validity/CrossingMotion.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Do points keep to their side of the plane that turns with the link, by more than `contact`?
template <class Points>
bool keepBeside(const LinkMotion<3> &link, const Nearness &near, const Points &points, double contact)
{
    for (const Vector3d &point : points)
        if (!(link.leastBeside(-near.normal, resting<3>(point)) > contact))
            return false;
    return true;
}

/// The same of the plane that also stays parallel to an edge.
template <class Points>
bool keepAcross(const LinkMotion<3> &link, const Nearness &near, const Vector3d &edge, const Points &points,
                double contact)
{
    const CrossingMotion plane(link, near.fraction, resting(edge), near.normal);
    for (const Vector3d &point : points)
        if (!plane.keepsAway(resting<3>(point), contact))
            return false;
    return true;
}

/// Of a point of a face: is it on the line through two of its corners?
bool isOnEdge(const Vector3d &foot, const Vector3d &from, const Vector3d &to)
{
    return (to - from).cross(foot - from).norm() <= 1e-9 * (to - from).squaredNorm();
}
}  // namespace

bool passes(const LinkMotion<3> &link, const Nearness &near, const Sphere &sphere)
{
    return keepBeside(link, near, std::array<Vector3d, 1>{sphere.center}, link.radius + sphere.radius);
}

bool passes(const LinkMotion<3> &link, const Nearness &near, const Capsule &capsule)
{
    const double contact = link.radius + capsule.radius;
    const Vector3d along = capsule.to - capsule.from;
    const double place = along.dot(near.point - capsule.from);
    const double square = along.squaredNorm();
    if (place <= 0.0 || place >= square)
        return keepBeside(link, near, std::array<Vector3d, 2>{capsule.from, capsule.to}, contact);
    return keepAcross(link, near, along, std::array<Vector3d, 1>{capsule.from + place / square * along}, contact);
}

bool passes(const LinkMotion<3> &link, const Nearness &near, const Cylinder &cylinder)
{
    const double height = cylinder.axis.dot(near.point - cylinder.center);
    const Vector3d level = cylinder.center + height * cylinder.axis;
    if (std::abs(height) <= cylinder.halfLength)
        return keepAcross(link, near, cylinder.axis, std::array<Vector3d, 1>{level}, link.radius + cylinder.radius);
    // Over the rim: planes parallel to its tangent see of the cylinder its cut through axis and foot, a rectangle.
    const Vector3d radial = near.point - level;
    const double length = radial.norm();
    if (!(length > 0.0))
        return false;
    const Vector3d outward = cylinder.radius / length * radial;
    const Vector3d upward = cylinder.halfLength * cylinder.axis;
    const std::array<Vector3d, 4> corners{cylinder.center + outward + upward, cylinder.center + outward - upward,
                                          cylinder.center - outward + upward, cylinder.center - outward - upward};
    return keepAcross(link, near, cylinder.axis.cross(radial / length), corners, link.radius);
}

bool passes(const LinkMotion<3> &link, const Nearness &near, const Box &box)
{
    const auto axes = box.pose.linear();
    const Vector3d local = axes.transpose() * (near.point - box.pose.translation());
    const auto isBeyond = [&](int axis)
    {
        return std::abs(local[axis]) > box.halfExtents[axis];
    };
    for (int axis = 0; axis < 3; ++axis)
    {
        const int second = (axis + 1) % 3, third = (axis + 2) % 3;
        if (isBeyond(axis) || !isBeyond(second) || !isBeyond(third))
            continue;
        const Vector3d level = box.pose.translation() + local[axis] * axes.col(axis);
        const Vector3d one = box.halfExtents[second] * axes.col(second);
        const Vector3d other = box.halfExtents[third] * axes.col(third);
        const std::array<Vector3d, 4> edges{level + one + other, level + one - other, level - one + other,
                                            level - one - other};
        return keepAcross(link, near, axes.col(axis), edges, link.radius);
    }
    std::array<Vector3d, 8> corners;
    for (int k = 0; k < 8; ++k)
        corners[k] = box.pose * Vector3d(box.halfExtents.cwiseProduct(
                                    Vector3d(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0)));
    return keepBeside(link, near, corners, link.radius);
}

/// Beside the mantle, planes parallel to the axis see only the section; over an end, planes parallel to one of its
/// sides, or to none, see all corners.
bool passes(const LinkMotion<3> &link, const Nearness &near, const Prism &prism)
{
    const auto corner = [&](std::size_t i, double height)
    {
        const Eigen::Vector2d &vertex = prism.vertices[i % prism.vertices.size()];
        return Vector3d(prism.pose * Vector3d(vertex.x(), vertex.y(), height));
    };
    const double height = prism.axis().dot(near.point - prism.pose.translation());
    std::vector<Vector3d> corners;
    const bool isBeside = std::abs(height) <= prism.halfLength;
    for (std::size_t i = 0; i < prism.vertices.size(); ++i)
        for (const double side : {-1.0, 1.0})
            if (!isBeside)
                corners.push_back(corner(i, side * prism.halfLength));
            else if (side > 0.0)
                corners.push_back(corner(i, height));
    if (isBeside)
        return keepAcross(link, near, prism.axis(), corners, link.radius);
    const double end = std::copysign(prism.halfLength, height);
    for (std::size_t i = 0; i < prism.vertices.size(); ++i)
        if (isOnEdge(near.foot(), corner(i, end), corner(i + 1, end)) &&
            keepAcross(link, near, corner(i + 1, end) - corner(i, end), corners, link.radius))
            return true;
    return keepBeside(link, near, corners, link.radius);
}

bool passes(const LinkMotion<3> &link, const Nearness &near, const Triangle &triangle)
{
    const Vector3d foot = near.foot();
    for (int i = 0; i < 3; ++i)
    {
        const Vector3d &from = triangle[i], &to = triangle[(i + 1) % 3];
        if (isOnEdge(foot, from, to) && keepAcross(link, near, to - from, triangle, link.radius))
            return true;
    }
    return keepBeside(link, near, triangle, link.radius);
}
}  // namespace narrows
