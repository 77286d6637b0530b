// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include "kernel/PlanarObstacle.h"
#include "scenario/families/Family.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
/// What stands on either side of a gap.
enum class GapShape
{
    Circle,
    Box,           ///< a turned plate, its narrow end along the gap: a short channel
    Superellipse,  ///< upright, whatever the direction of the gap
    Polygon        ///< convex, with one corner in the gap
};

/// The parameter that chooses one of them: "circle", as if not given, "box", "superellipse" or "polygon".
FamilyParameter gapShapeParameter();
GapShape gapShapeOf(const FamilyValues &values);

/// An obstacle that touches the line through `touch` at right angles to `outwards` at that point, nowhere crosses it
/// and lies to the side of `outwards`. Coordinates are rounded to 12 decimals.
/// \param outwards unit vector
/// \param size its radius, or half of its greater diameter (a box: of its length at right angles to the gap)
/// \param random used for polygons and superellipses only
std::variant<Circle, Superellipse, Polygon> placeAtGap(GapShape shape, const Eigen::Vector2d &touch,
                                                       const Eigen::Vector2d &outwards, double size,
                                                       RandomNumbers &random);
}  // namespace narrows
