// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SpatialModel.h"
#include "kernel/scaling/ScalingProblem.h"

namespace narrows
{
/// Projects obstacles along the slide of a chain into the convex sections that the scaling method passes.
///
/// Balls, capsules and what is extruded along the slide are projected exactly; a cylinder across it becomes a polygon
/// around it, a mesh its convex hull. Every section contains its obstacle, over the stretch of the slide where that is.
/// Cylinders and capsules that lie across the slide and whose ends no arm of this reach can go round become crossbars.
/// What is out of reach altogether is left out.
void addObstacles(const std::vector<SpatialObstacle> &obstacles, const ChainGeometry &chain, ScalingProblem &problem);
}  // namespace narrows
