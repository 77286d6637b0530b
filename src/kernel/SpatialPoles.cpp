// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialPoles.h"

#include <algorithm>
#include <cmath>

#include "kernel/SpatialBounds.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Radius of the ball that is as large as a box.
double ballRadius(const Vector3d &halfExtents)
{
    return std::cbrt(6.0 / std::acos(-1.0) * halfExtents.prod());
}

/// The same of a prism; without ends, of the disc that is as large as its section.
double ballRadius(const Prism &prism)
{
    const double pi = std::acos(-1.0);
    double area = 0.0;
    for (std::size_t i = 0; i < prism.vertices.size(); ++i)
    {
        const Eigen::Vector2d &one = prism.vertices[i], &next = prism.vertices[(i + 1) % prism.vertices.size()];
        area += 0.5 * (one.x() * next.y() - one.y() * next.x());
    }
    return std::isinf(prism.halfLength) ? std::sqrt(area / pi) : std::cbrt(1.5 / pi * area * prism.halfLength);
}

struct MakePole
{
    double longest;  ///< R of shapes that are larger than this
    double far;      ///< no link gets further from the origin

    SpatialPole operator()(const Sphere &sphere) const { return {sphere, 2.0 * sphere.radius}; }
    SpatialPole operator()(const Capsule &capsule) const { return {capsule, 2.0 * capsule.radius}; }
    SpatialPole operator()(const Cylinder &cylinder) const { return {cylinder, 2.0 * cylinder.radius}; }
    SpatialPole operator()(const Box &box) const
    {
        return {EdgedPole(box), 2.0 * std::min(longest, ballRadius(box.halfExtents))};
    }
    SpatialPole operator()(const Prism &prism) const
    {
        return {EdgedPole(prism, far), 2.0 * std::min(longest, ballRadius(prism))};
    }
    SpatialPole operator()(const Mesh &mesh) const
    {
        const SpatialBounds box = spatialBounds(mesh);
        return {MeshGeometry(mesh), 2.0 * std::min(longest, ballRadius(0.5 * (box.upper - box.lower)))};
    }
};

struct NearnessTo
{
    const Vector3d &a, &b;

    template <class Convex>
    Nearness operator()(const Convex &shape) const
    {
        return nearness(a, b, shape);
    }
    Nearness operator()(const EdgedPole &solid) const { return solid.nearest(a, b); }
    Nearness operator()(const MeshGeometry &mesh) const { return mesh.nearest(a, b); }
};
}  // namespace

SpatialTerm SpatialPole::smoothClearance(const Vector3d &a, const Vector3d &b, double linkRadius, int &guess) const
{
    if (const auto *mesh = std::get_if<MeshGeometry>(&shape))
        return clearanceOf(mesh->nearest(a, b, &guess), linkRadius);
    if (const auto *solid = std::get_if<EdgedPole>(&shape))
        return solid->clearance(a, b, linkRadius);
    return clearance(a, b, linkRadius);
}

SpatialTerm SpatialPole::clearance(const Vector3d &a, const Vector3d &b, double linkRadius) const
{
    return clearanceOf(std::visit(NearnessTo{a, b}, shape), linkRadius);
}

SpatialPoles::SpatialPoles(const SpatialModel &model) : arm_(model.arm)
{
    double longest = 0.0;
    for (const SpatialLink &link : arm_.links())
        longest = std::max(longest, (link.to - link.from).norm());
    pairSize_ = longest;
    for (const SpatialObstacle &obstacle : model.obstacles)
    {
        obstacles_.push_back(std::visit(MakePole{0.5 * longest, farthestFromOrigin(arm_)}, obstacle.shape));
        groups_.push_back(obstacle.name);
    }
    addLimits();
    if (model.selfCollision)
        addPairs();
}

void SpatialPoles::addLimits()
{
    for (int i = 0; i < arm_.dimension(); ++i)
    {
        const auto &limits = arm_.joints()[i].limits;
        // What a universal limit already says needs no pole of its own.
        const bool implied = std::any_of(arm_.universalLimits().begin(), arm_.universalLimits().end(),
                                         [&](const UniversalLimit &both)
                                         {
                                             return (both.first == i || both.second == i) && limits &&
                                                    -limits->lower >= both.maxAngle && limits->upper >= both.maxAngle;
                                         });
        if (!limits || implied)
            continue;
        limits_.push_back({1.0, i, limits->lower});
        limits_.push_back({-1.0, i, limits->upper});
    }
    if (limits_.empty() && arm_.universalLimits().empty())
        return;
    limitGroup_ = static_cast<int>(groups_.size());
    groups_.push_back("limits");
}

void SpatialPoles::addPairs()
{
    for (int first = 0; first < arm_.linkCount(); ++first)
        for (int second = first + 1; second < arm_.linkCount(); ++second)
            if (!arm_.areNeighbours(first, second))
                pairs_.emplace_back(first, second);
    if (pairs_.empty())
        return;
    selfGroup_ = static_cast<int>(groups_.size());
    groups_.push_back("self");
}

SpatialPairTerm pairClearance(const SpatialArm &arm, const SpatialArm::Placement &placement, int first, int second)
{
    const Vector3d &a = placement.points[2 * first], &b = placement.points[2 * first + 1];
    const Vector3d &c = placement.points[2 * second], &d = placement.points[2 * second + 1];
    const ClosestFractions closest = closestFractions(a, b, c, d);
    const Vector3d apart = a + closest.first * (b - a) - c - closest.second * (d - c);
    const double distance = apart.norm();
    const Vector3d normal = distance > 0.0 ? Vector3d(apart / distance) : perpendicular(b - a);
    SpatialPairTerm term{distance - arm.links()[first].radius - arm.links()[second].radius, {}, {}};
    term.first.push(closest.first, normal);
    term.second.push(closest.second, -normal);
    return term;
}
}  // namespace narrows
