// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// A place between two obstacles in space where they are nearest to each other. A slot is one gap; a hole between walls
/// is one for every pair of walls that face each other, so that its middle is fixed across all of them.
struct SpatialGap
{
    Eigen::Vector3d middle;  ///< half way between the obstacles, amid what of them faces each other
    Eigen::Vector3d axis;    ///< unit vector across the gap, from one obstacle to the other
    /// Unit vector along which the gap stays narrow, as a slot does, square to `axis`. Zero if there is none: links go
    /// through near the middle, whichever way (two balls), or on a broad front (two plates).
    Eigen::Vector3d along;
    double halfLength;    ///< of what stays narrow, to both sides along `along`; 0 if that is zero
    double halfDistance;  ///< between the obstacles; > 0
    double size;          ///< half of how thick the narrow part is, the way links go; > 0
};

/// All gaps between convex obstacles, and of meshes: between two of them, between one and a convex obstacle, and
/// between faces of one that look at each other (the opening of a ring). What other obstacles fill of a gap is cut off.
/// \param thinnest radius of the thinnest link; >= 0
/// \param widest half of the widest room that is left to it; > 0
/// \param far no link gets further from the origin; > 0
/// \throws std::invalid_argument if one of these is out of range.
std::vector<SpatialGap> findGaps(const std::vector<SpatialObstacle> &obstacles, double thinnest, double widest,
                                 double far);
}  // namespace narrows
