// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Solids.h"
#include "SpatialRobots.h"
#include "kernel/MeshGeometry.h"

namespace narrows
{
/// A random obstacle of the given kind: 0 sphere, 1 capsule, 2 cylinder, 3 cylinder without ends, 4 box, 5 closed mesh,
/// 6 prism, 7 prism without ends.
inline SpatialObstacle randomObstacle(int kind, std::mt19937 &generator)
{
    const double size = 0.05 + 0.4 * randomPoint(1.0, generator).cwiseAbs().x();
    switch (kind)
    {
        case 0:
            return {"sphere", Sphere{randomPoint(0.5, generator), size}};
        case 1:
            return {"capsule", Capsule{randomPoint(0.7, generator), randomPoint(0.7, generator), 0.5 * size}};
        case 2:
            return {"cylinder", randomCylinder(false, generator)};
        case 3:
            return {"pipe", randomCylinder(true, generator)};
        case 4:
            return {"box", randomBox(generator)};
        case 6:
            return {"prism", randomPrism(false, generator)};
        case 7:
            return {"endless prism", randomPrism(true, generator)};
        default:
            return {"mesh", boxMesh(randomBox(generator), 3)};
    }
}
constexpr int obstacleKinds = 8;

/// Exact signed distance between a segment and an obstacle, as the kernel has it.
inline Nearness nearnessOf(const SpatialObstacle &obstacle, const Eigen::Vector3d &a, const Eigen::Vector3d &b)
{
    return std::visit(
        [&](const auto &shape)
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
                return MeshGeometry(shape).nearest(a, b);
            else
                return nearness(a, b, shape);
        },
        obstacle.shape);
}

struct ShiftBy
{
    Eigen::Vector3d way;

    void operator()(Sphere &sphere) const { sphere.center += way; }
    void operator()(Capsule &capsule) const
    {
        capsule.from += way;
        capsule.to += way;
    }
    void operator()(Cylinder &cylinder) const { cylinder.center += way; }
    void operator()(Box &box) const { box.pose.pretranslate(way); }
    void operator()(Prism &prism) const { prism.pose.pretranslate(way); }
    void operator()(Mesh &mesh) const
    {
        for (Eigen::Vector3d &vertex : mesh.vertices)
            vertex += way;
    }
};

/// Moves an obstacle until it is `gap` (to 1 %) away from what is within `radius` of a segment. False if that does not
/// work out.
inline bool bringNear(SpatialObstacle &obstacle, const Eigen::Vector3d &a, const Eigen::Vector3d &b, double radius,
                      double gap)
{
    for (int round = 0; round < 60; ++round)
    {
        const Nearness near = nearnessOf(obstacle, a, b);
        const double excess = near.distance - radius - gap;
        if (near.distance > 0.0 && std::abs(excess) < 0.01 * gap)
            return true;
        std::visit(ShiftBy{0.9 * excess * near.normal}, obstacle.shape);
    }
    return false;
}
}  // namespace narrows
