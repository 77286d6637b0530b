// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialBounds.h"

#include <algorithm>
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

SpatialBounds spatialBounds(const Prism &prism)
{
    Vector3d half = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (const double along = std::abs(prism.axis()[i]); along > 0.0)  // 0 times infinity is nothing here
            half[i] = along * prism.halfLength;
    const auto corner = [&](const Eigen::Vector2d &vertex)
    {
        return Vector3d(prism.pose * Vector3d(vertex.x(), vertex.y(), 0.0));
    };
    SpatialBounds section{corner(prism.vertices.at(0)), corner(prism.vertices.at(0))};
    for (const Eigen::Vector2d &vertex : prism.vertices)
        section = {section.lower.cwiseMin(corner(vertex)), section.upper.cwiseMax(corner(vertex))};
    return {section.lower - half, section.upper + half};
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

double farthestFromOrigin(const SpatialArm &arm)
{
    double distance = 0.0;
    for (const SpatialJoint &joint : arm.joints())
        if (joint.parent < 0)
            distance = std::max(distance, joint.offset.translation().norm() + arm.reach());
    for (const SpatialLink &link : arm.links())
        if (link.joint < 0)
            distance = std::max(distance, std::max(link.from.norm(), link.to.norm()) + link.radius);
    return distance;
}
}  // namespace narrows
