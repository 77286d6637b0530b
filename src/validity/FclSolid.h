// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <fcl/geometry/collision_geometry.h>

#include "kernel/SpatialBounds.h"

namespace narrows
{
/// FCL's yes-or-no query with its default solver (libccd) misses overlaps of less than its tolerance of 1e-6 and
/// nothing else, so capsules this much thicker err on the safe side only; links without a radius get a robust one by
/// the way. Its other solver misses deep overlaps, and distances of both are now and then far off:
/// tests/FclCheckerTest.cpp, tests/SpatialFclCheckerTest.cpp.
constexpr double fclResolution = 1e-6;

/// A shape of FCL's in its place.
struct FclSolid
{
    std::shared_ptr<const fcl::CollisionGeometryd> geometry;
    Eigen::Isometry3d pose;
    SpatialBounds box;
    Eigen::Vector3d anchor;  ///< some point of the solid
};

/// A solid that is within `radius` of the segment ab. Errs by less than twice the resolution, outwards.
FclSolid fclCapsule(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double radius);

/// A segment, to be compared with solids.
class FclSegment
{
public:
    FclSegment(const Eigen::Vector3d &a, const Eigen::Vector3d &b);

    const Eigen::Vector3d &end() const { return a_; }

    /// No greater than the distance to the solid.
    double boxDistance(const FclSolid &solid) const;

    /// Whether the solid keeps away from the segment by more than the distance. Errs, by less than twice the
    /// resolution, towards "no"; whatever makes FCL throw counts as "no" too.
    bool clears(const FclSolid &solid, double distance) const;

    /// Distance of the segment from the solid, less `radius`; 0 if that is not positive. Errs by less than ten times
    /// the resolution, towards 0.
    double clearance(const FclSolid &solid, double radius) const;

private:
    double claimedDistance(const FclSolid &solid) const;

    Eigen::Vector3d a_, b_;
    double length_;
    Eigen::Isometry3d pose_;
};
}  // namespace narrows
