// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// Where a surface is open: an edge, named by its ends, that does not lie between exactly two triangles. Empty if there
/// is none.
std::string findOpening(const Mesh &mesh);

/// Turns the triangles of a surface without openings counter-clockwise as seen from outside.
/// \return what is wrong if it does not bound a solid, such as that it crosses itself; empty else
std::string orientOutwards(Mesh &mesh);
}  // namespace narrows
