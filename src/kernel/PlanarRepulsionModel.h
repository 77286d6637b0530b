// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/PlanarModel.h"
#include "kernel/Repulsion.h"

namespace narrows
{
/// Poles of a planar arm among obstacles, at its joint limits and, where the model asks for it, against itself. Groups:
/// the obstacles' names; "limits" if a joint or the slide has any; "self" if the model asks for it and two links do not
/// meet at a joint.
///
/// What counts as C in W = sum of P / C of continuous(), with e the clearance of the pair (distance - link radius, or -
/// twice the radius between links) and R half the longest link or, if that is less, the radius of the circle that is as
/// large as the shape:
///   circles          d^2 - r^2, d the distance of the link from the center, r grown by the link radius;
///   superellipses    e (e + 2 (R + link radius)); where links have no radius, e is not the distance but, ten times
///                    cheaper and 0 at the same place, m (g - 1), with m the lesser half extent and g the least of
///                    (|x/a|^p + |y/b|^p)^(1/p) along the link: for a circle the same;
///   polygons         e (e + 2 (R + link radius)) with a smooth minimum e (SmoothMinimum.h) of the clearances between
///                    corners and link and between link ends and edges, since their minimum has kinks where a link lies
///                    parallel to an edge;
///   link and link    e (e + 2 (R + twice the radius)), R half the longest link, e the smooth minimum over the ends;
///   joint limits     value - lower and upper - value, two poles per limited joint or slide; angles count as they are,
///                    without regard to whole turns: callers bring start and goal into the limits' interval.
/// All are 0 exactly where the pair begins to touch, once continuously differentiable outside, finite and negative
/// inside: in proportion to the depth there, which is the least shift that frees the link of a convex part of a polygon
/// or of another link, and for superellipses m (1 - g). Units: length^2, limits: radians (slide: length). Poles are
/// listed by groups and in them by links (limits: lower, upper, slide first; self: pairs (i, j) with i < j, by i).
///
/// points() serves obstacles only and refuses strengths other than 0 for the groups "limits" and "self".
/// \throws std::invalid_argument if there are more limits than links (missing ones: the joint turns freely).
std::shared_ptr<const RepulsionModel> planarRepulsionModel(std::shared_ptr<const PlanarModel> model,
                                                           const JointLimits &limits);
}  // namespace narrows
