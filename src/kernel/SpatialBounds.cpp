// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialBounds.h"

#include <cmath>

namespace narrows
{
using Eigen::Vector3d;

SpatialBounds spatialBounds(const Sphere &sphere)
{
    return boundsAround(sphere.center, sphere.center, sphere.radius);
}

SpatialBounds spatialBounds(const Capsule &capsule)
{
    return boundsAround(capsule.from, capsule.to, capsule.radius);
}

SpatialBounds spatialBounds(const Cylinder &cylinder)
{
    Vector3d half;
    for (int i = 0; i < 3; ++i)
    {
        const double along = std::abs(cylinder.axis[i]);
        half[i] = cylinder.radius * std::sqrt(std::max(0.0, 1.0 - along * along));
        if (along > 0.0)  // 0 times infinity is nothing here
            half[i] += along * cylinder.halfLength;
    }
    return {cylinder.center - half, cylinder.center + half};
}

SpatialBounds spatialBounds(const Box &box)
{
    const Vector3d half = box.pose.linear().cwiseAbs() * box.halfExtents;
    return {box.pose.translation() - half, box.pose.translation() + half};
}

SpatialBounds spatialBounds(const Mesh &mesh)
{
    SpatialBounds bounds{mesh.vertices.at(0), mesh.vertices.at(0)};
    for (const Vector3d &vertex : mesh.vertices)
        bounds = {bounds.lower.cwiseMin(vertex), bounds.upper.cwiseMax(vertex)};
    return bounds;
}

SpatialBounds spatialBounds(const SpatialObstacle &obstacle)
{
    return std::visit([](const auto &shape) { return spatialBounds(shape); }, obstacle.shape);
}
}  // namespace narrows
