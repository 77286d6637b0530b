// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/threading/ConvexShape.h"

namespace narrows
{
/// A place between two obstacles where they are nearest to each other: what a link can thread.
struct Gap
{
    Eigen::Vector2d middle;  ///< half way between the nearest points
    Eigen::Vector2d axis;    ///< unit vector across the gap, from one obstacle to the other
    double halfWidth;        ///< half the distance, less the links' radius; > 0
    double size;             ///< half the greater extent, along or across `axis`, of the lesser obstacle
};

/// All gaps between convex obstacles or convex parts of obstacles, in the order of their pairs.
/// \param linkRadius half width of what shall thread them; >= 0
/// \param widest gaps of at least this half width are left out
/// \throws std::invalid_argument if linkRadius is negative or widest not positive.
std::vector<Gap> findGaps(const std::vector<PlanarObstacle> &obstacles, double linkRadius, double widest);
}  // namespace narrows
