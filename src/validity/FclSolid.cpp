// SPDX-License-Identifier: BSD-3-Clause
#include "validity/FclSolid.h"

#include <algorithm>
#include <exception>
#include <limits>

#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// FCL's capsules stand along z.
Eigen::Isometry3d capsulePose(const Vector3d &a, const Vector3d &b)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    const Vector3d along = b == a ? Vector3d(Vector3d::UnitZ()) : (b - a).normalized();
    const Vector3d across = perpendicular(along);
    pose.linear() << across, along.cross(across), along;
    pose.translation() = 0.5 * (a + b);
    return pose;
}
}  // namespace

FclSolid fclCapsule(const Vector3d &a, const Vector3d &b, double radius)
{
    return {std::make_shared<fcl::Capsuled>(radius + fclResolution, (b - a).norm()), capsulePose(a, b),
            boundsAround(a, b, radius), a};
}

FclSegment::FclSegment(const Vector3d &a, const Vector3d &b)
  : a_(a), b_(b), length_((b - a).norm()), pose_(capsulePose(a, b))
{
}

double FclSegment::boxDistance(const FclSolid &solid) const
{
    const Vector3d below = solid.box.lower - a_.cwiseMax(b_), above = a_.cwiseMin(b_) - solid.box.upper;
    return below.cwiseMax(above).cwiseMax(0.0).norm();
}

bool FclSegment::clears(const FclSolid &solid, double distance) const
{
    const fcl::Capsuled capsule(distance + fclResolution, length_);
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    try
    {
        return fcl::collide(&capsule, pose_, solid.geometry.get(), solid.pose, request, result) == 0;
    }
    catch (const std::exception &)
    {
        return false;
    }
}

/// FCL's answer, right most of the time; NaN if it throws.
double FclSegment::claimedDistance(const FclSolid &solid) const
{
    const fcl::Capsuled capsule(fclResolution, length_);
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    try
    {
        return fcl::distance(&capsule, pose_, solid.geometry.get(), solid.pose, request, result) + fclResolution;
    }
    catch (const std::exception &)
    {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

/// A distance that FCL claims is believed only if its yes-or-no query confirms it from both sides; else the latter
/// finds it alone, by bisection.
double FclSegment::clearance(const FclSolid &solid, double radius) const
{
    if (!clears(solid, radius))
        return 0.0;
    double low = radius, high = std::max((solid.anchor - a_).norm(), radius + fclResolution);
    const double claimed = claimedDistance(solid);
    if (claimed - 4.0 * fclResolution > low && clears(solid, claimed - 4.0 * fclResolution))
        low = claimed - 4.0 * fclResolution;
    if (claimed + 4.0 * fclResolution < high && !clears(solid, claimed + 4.0 * fclResolution))
        high = claimed + 4.0 * fclResolution;
    while (high - low > 10.0 * fclResolution)
    {
        const double middle = 0.5 * (low + high);
        (clears(solid, middle) ? low : high) = middle;
    }
    return std::max(low - radius, 0.01 * fclResolution);
}
}  // namespace narrows
