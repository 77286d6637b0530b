// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// What two shapes have in common where they face each other across a gap, seen along its axis: a rectangle.
struct FacingPatch
{
    Eigen::Vector3d middle;  ///< off the axis; its component along it means nothing
    Eigen::Vector3d along;   ///< unit vector of the longer sides, square to the gap's axis
    double halfLength;       ///< of the longer sides; >= 0
    double halfBreadth;      ///< of the shorter ones; >= 0
};

/// \param axis unit vector
/// \param first, second points that span what faces the gap (SpatialShape::facing); not empty. Their rectangle is the
/// least of those that have a side along a line through two of them; exact for rectangles with parallel sides
/// \param middle is taken where they only have a point in common: a corner, or edges that cross
FacingPatch facingPatch(const std::vector<Eigen::Vector3d> &first, const std::vector<Eigen::Vector3d> &second,
                        const Eigen::Vector3d &axis, const Eigen::Vector3d &middle);
}  // namespace narrows
