// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SpatialCertificates.h"

#include "validity/CrossingMotion.h"
#include "validity/PassingPlanes.h"

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
    return examineConvex(link, reach, sphere);
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

Finding examine(const LinkMotion<3> &link, double reach, const Prism &prism)
{
    return examineConvex(link, reach, prism);
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
