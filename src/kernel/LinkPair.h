// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SmoothMinimum.h"

namespace narrows
{
/// Do the segments cross in their interiors?
bool cross(const Segment &first, const Segment &second);

/// The obstacle function C of PlanarRepulsionModel.h for two links.
/// \param radius the sum of their radii
PairTerm pairPole(const Segment &first, const Segment &second, double radius, double size);

/// Distance of the links' edges; where their segments cross, less the least shift that takes them apart.
PairTerm pairClearance(const Segment &first, const Segment &second, double radius);
}  // namespace narrows
