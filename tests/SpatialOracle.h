// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// The dumbest possible distances in space, as an oracle: of single points. Negative or zero inside.
struct DistanceOfPoint
{
    Eigen::Vector3d point;

    double operator()(const Sphere &ball) const { return (point - ball.center).norm() - ball.radius; }

    double operator()(const Capsule &capsule) const
    {
        const Eigen::Vector3d along = capsule.to - capsule.from;
        const double t = std::clamp((point - capsule.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (point - capsule.from - t * along).norm() - capsule.radius;
    }

    double operator()(const Cylinder &cylinder) const
    {
        const double along = (point - cylinder.center).dot(cylinder.axis);
        const double across = (point - cylinder.center - along * cylinder.axis).norm() - cylinder.radius;
        const double beyond = std::abs(along) - cylinder.halfLength;
        return outside(Eigen::Vector3d(across, beyond, -std::numeric_limits<double>::infinity()));
    }

    double operator()(const Box &box) const
    {
        return outside((box.pose.inverse() * point).cwiseAbs() - box.halfExtents);
    }

    /// The nearest corner of the section's own plane cut by its sides' lines: the deepest of the sides inside, else the
    /// nearest point of any side.
    double operator()(const Prism &prism) const
    {
        const Eigen::Vector3d local = prism.pose.inverse() * point;
        double across = -std::numeric_limits<double>::infinity(), nearest = -across;
        for (std::size_t i = 0; i < prism.vertices.size(); ++i)
        {
            const Eigen::Vector2d &from = prism.vertices[i], &to = prism.vertices[(i + 1) % prism.vertices.size()];
            const Eigen::Vector2d side = to - from, way = local.head<2>() - from;
            across = std::max(across, (side.y() * way.x() - side.x() * way.y()) / side.norm());
            const double t = std::clamp(way.dot(side) / side.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (way - t * side).norm());
        }
        const double beyond = std::abs(local.z()) - prism.halfLength;
        const double beside = across <= 0.0 ? across : nearest;
        return outside(Eigen::Vector3d(beside, beyond, -std::numeric_limits<double>::infinity()));
    }

    double operator()(const Mesh &) const { throw std::logic_error("ask for the box that the mesh covers"); }

private:
    /// Of a corner where all three slabs meet at right angles.
    static double outside(const Eigen::Vector3d &excess)
    {
        return excess.maxCoeff() <= 0.0 ? excess.maxCoeff() : excess.cwiseMax(0.0).norm();
    }
};

/// Least distance of points on the links to the obstacles, minus the links' radii. Nothing of self-collision.
inline double sampledClearance(const SpatialModel &model, const Eigen::VectorXd &q, int samples)
{
    SpatialArm::Placement placement;
    model.arm.place(q, placement);
    double least = std::numeric_limits<double>::infinity();
    for (int link = 0; link < model.arm.linkCount(); ++link)
        for (int k = 0; k <= samples; ++k)
        {
            const Eigen::Vector3d &from = placement.points[2 * link], &to = placement.points[2 * link + 1];
            const DistanceOfPoint distance{from + (to - from) * (static_cast<double>(k) / samples)};
            for (const SpatialObstacle &obstacle : model.obstacles)
                least = std::min(least, std::visit(distance, obstacle.shape) - model.arm.links()[link].radius);
        }
    return least;
}

/// Least distance between points on links that are not neighbours, minus the links' radii.
inline double sampledSelfClearance(const SpatialArm &arm, const Eigen::VectorXd &q, int samples)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    const auto pointOf = [&](int link, int k)
    {
        const Eigen::Vector3d &from = placement.points[2 * link], &to = placement.points[2 * link + 1];
        return Eigen::Vector3d(from + (to - from) * (static_cast<double>(k) / samples));
    };
    double least = std::numeric_limits<double>::infinity();
    for (int link = 0; link < arm.linkCount(); ++link)
        for (int other = 0; other < link; ++other)
            for (int k = 0; k <= samples && !arm.areNeighbours(link, other); ++k)
                for (int j = 0; j <= samples; ++j)
                    least = std::min(least, (pointOf(link, k) - pointOf(other, j)).norm() - arm.links()[link].radius -
                                                arm.links()[other].radius);
    return least;
}

/// The surface of a box: twelve triangles, turned outwards.
inline Mesh surfaceOf(const Box &box)
{
    Mesh mesh{{}, {}, true};
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(box.pose * Eigen::Vector3d((i & 1 ? 1 : -1) * box.halfExtents.x(),
                                                           (i & 2 ? 1 : -1) * box.halfExtents.y(),
                                                           (i & 4 ? 1 : -1) * box.halfExtents.z()));
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}
}  // namespace narrows
