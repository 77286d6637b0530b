// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/Repulsion.h"
#include "kernel/SpatialModel.h"

namespace narrows
{
/// Poles of a spatial arm among obstacles, at its limits and, where the model asks for it, against itself. Groups: the
/// obstacles' names; "limits" if there are any; "self" if the model asks for it and two links are not neighbours.
///
/// What counts as C in W = sum of P / C of continuous(), with e the clearance of the pair (distance - link radius):
///   spheres, capsules, cylinders   e (e + 2 (R + link radius)), R their radius: d^2 - r^2 with d the distance from the
///                                  center or axis and r grown by the link radius;
///   boxes, prisms                  the same, with R the radius of the ball that is as large as the solid (of the disc
///                                  as large as its section, if it has no ends), at most half the longest link, and a
///                                  smooth stand-in for e (EdgedPole.h);
///   meshes                         the same, with the ball of the mesh's bounding box and the exact e, whose slope
///                                  jumps where the nearest point does;
///   link and link                  likewise, with R half the longest link and the sum of their radii;
///   joint limits                   value - lower and upper - value;
///   universal limits               cos(first) cos(second) - cos(maxAngle).
/// All are 0 exactly where the pair begins to touch, finite and negative inside, linear in the depth there; links
/// without radius that cross each other, which have no depth, are the exception. Angles count as they are, without
/// regard to whole turns. Poles are listed by groups and in them by links (self: by pairs; limits last, by joints,
/// lower before upper, then universal ones).
///
/// The paper has no singular points in space: points() throws.
std::shared_ptr<const RepulsionModel> spatialRepulsionModel(std::shared_ptr<const SpatialModel> model);
}  // namespace narrows
