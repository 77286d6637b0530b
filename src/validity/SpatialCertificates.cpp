// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SpatialCertificates.h"

#include <array>

#include "validity/CrossingMotion.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

bool isInner(double fraction)
{
    return fraction > 0.0 && fraction < 1.0;
}

/// What needs no plane that turns. A convex obstacle is on one side of the plane through its foot.
Finding atRest(const LinkMotion<3> &link, double reach, const Nearness &near)
{
    if (near.distance > link.radius + reach)
        return Finding::Clear;
    if (!(near.distance > link.radius))
        return Finding::Touching;
    return link.leastAlong(near.normal) - near.normal.dot(near.foot()) > link.radius ? Finding::Clear : Finding::Unsure;
}

Finding clearIf(bool certain)
{
    return certain ? Finding::Clear : Finding::Unsure;
}

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

bool passes(const LinkMotion<3> &link, const Nearness &near, const Triangle &triangle)
{
    const Vector3d foot = near.foot();
    for (int i = 0; i < 3; ++i)
    {
        const Vector3d edge = triangle[(i + 1) % 3] - triangle[i];
        const bool isOnEdge = edge.cross(foot - triangle[i]).norm() <= 1e-9 * edge.squaredNorm();
        if (isOnEdge && keepAcross(link, near, edge, triangle, link.radius))
            return true;
    }
    return keepBeside(link, near, triangle, link.radius);
}

template <class Convex>
Finding examineConvex(const LinkMotion<3> &link, double reach, const Nearness &near, const Convex &shape)
{
    const Finding finding = atRest(link, reach, near);
    if (finding != Finding::Unsure || !isInner(near.fraction))
        return finding;
    return clearIf(passes(link, near, shape));
}

template <class Convex>
Finding examineConvex(const LinkMotion<3> &link, double reach, const Convex &shape)
{
    return examineConvex(link, reach, nearness(link.a.position, link.b.position, shape), shape);
}

MovingPoint<3> pointOf(const LinkMotion<3> &link, double fraction)
{
    return {link.a.position + fraction * (link.b.position - link.a.position),
            link.a.velocity + fraction * (link.b.velocity - link.a.velocity), std::max(link.a.way, link.b.way),
            std::max(link.a.bend, link.b.bend)};
}
}  // namespace

Finding examine(const LinkMotion<3> &link, double reach, const Sphere &sphere)
{
    const Nearness near = nearness(link.a.position, link.b.position, sphere);
    const Finding finding = atRest(link, reach, near);
    if (finding != Finding::Unsure || !isInner(near.fraction))
        return finding;
    return clearIf(keepBeside(link, near, std::array<Vector3d, 1>{sphere.center}, link.radius + sphere.radius));
}

Finding examine(const LinkMotion<3> &link, double reach, const Capsule &capsule)
{
    return examineConvex(link, reach, capsule);
}

Finding examine(const LinkMotion<3> &link, double reach, const Cylinder &cylinder)
{
    return examineConvex(link, reach, cylinder);
}

Finding examine(const LinkMotion<3> &link, double reach, const Box &box)
{
    return examineConvex(link, reach, box);
}

Finding examine(const LinkMotion<3> &link, double reach, const MeshGeometry &mesh)
{
    Finding worst = Finding::Clear;
    mesh.visitWithin(link.a.position, link.b.position, link.radius + reach,
                     [&](const Triangle &triangle, const Nearness &near)
                     {
                         worst = std::max(worst, examineConvex(link, reach, near, triangle));
                         return worst != Finding::Touching;
                     });
    return worst != Finding::Touching && mesh.contains(link.a.position) ? Finding::Touching : worst;
}

Finding examine(const LinkMotion<3> &link, const LinkMotion<3> &other, double reach)
{
    const double contact = link.radius + other.radius;
    const ClosestFractions closest =
        closestFractions(link.a.position, link.b.position, other.a.position, other.b.position);
    const MovingPoint<3> near = pointOf(link, closest.first), far = pointOf(other, closest.second);
    const double distance = (near.position - far.position).norm();
    if (distance > contact + reach)
        return Finding::Clear;
    if (!(distance > contact))
        return Finding::Touching;
    const Vector3d normal = (near.position - far.position) / distance;
    if (link.leastApart(other, normal) > contact)
        return Finding::Clear;
    if (isInner(closest.first) && isInner(closest.second))
    {
        const MovingEdge edge{other.b.position - other.a.position, other.b.velocity - other.a.velocity, other.turn};
        return clearIf(CrossingMotion(link, closest.first, edge, normal).keepsAway(far, contact));
    }
    const auto isBeside = [&](const LinkMotion<3> &one, const LinkMotion<3> &ends, const Vector3d &towards)
    {
        return std::min(one.leastBeside(towards, ends.a), one.leastBeside(towards, ends.b)) > contact;
    };
    return clearIf((isInner(closest.first) && isBeside(link, other, -normal)) ||
                   (isInner(closest.second) && isBeside(other, link, normal)));
}
}  // namespace narrows
