// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <Eigen/Core>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// How a segment lies to a closed set.
struct Nearness
{
    /// Distance between them; where they meet, minus the depth of the segment's deepest point (its distance to the
    /// outside).
    double distance;
    double fraction;         ///< where on the segment that is: 0 at its first end, 1 at its second
    Eigen::Vector3d point;   ///< the same in space
    Eigen::Vector3d normal;  ///< unit vector: how `distance` changes with `point`

    /// Of the set, the point next to the segment.
    Eigen::Vector3d foot() const { return point - distance * normal; }
};

/// All of these take a segment ab, which may be a point.
///@{
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Sphere &sphere);
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Capsule &capsule);
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Cylinder &cylinder);
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Box &box);
Nearness nearness(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Prism &prism);
///@}

/// Where two segments ab and cd come closest: at a + first (b - a) and c + second (d - c).
struct ClosestFractions
{
    double first;   ///< along ab, in [0, 1]
    double second;  ///< along cd, in [0, 1]
};
/// Of segments on parallel lines, one of many such places.
ClosestFractions closestFractions(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c,
                                  const Eigen::Vector3d &d);

/// A unit vector perpendicular to `direction` (any unit vector if that is zero).
Eigen::Vector3d perpendicular(const Eigen::Vector3d &direction);
}  // namespace narrows
