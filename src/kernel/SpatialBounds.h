// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SpatialModel.h"

namespace narrows
{
/// An axis-parallel box; some sides of it may be infinitely far away.
struct SpatialBounds
{
    Eigen::Vector3d lower;  ///< least coordinates
    Eigen::Vector3d upper;  ///< greatest coordinates

    /// Whether the boxes have a point in common.
    bool meets(const SpatialBounds &other) const
    {
        return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
    }
};

/// The smallest such box around a shape.
///@{
SpatialBounds spatialBounds(const Sphere &sphere);
SpatialBounds spatialBounds(const Capsule &capsule);
SpatialBounds spatialBounds(const Cylinder &cylinder);
SpatialBounds spatialBounds(const Box &box);
SpatialBounds spatialBounds(const Prism &prism);
SpatialBounds spatialBounds(const Mesh &mesh);
SpatialBounds spatialBounds(const SpatialObstacle &obstacle);
///@}

/// How far from the origin any point of the arm can be, at most.
double farthestFromOrigin(const SpatialArm &arm);

/// Around all within `room` of the segment ab.
inline SpatialBounds boundsAround(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double room)
{
    return {a.cwiseMin(b).array() - room, a.cwiseMax(b).array() + room};
}
}  // namespace narrows
