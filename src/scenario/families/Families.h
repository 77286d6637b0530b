// SPDX-License-Identifier: BSD-3-Clause
// The families, each with its parameters; see Family.h.
#pragma once

#include "scenario/families/Family.h"

namespace narrows
{
/// HPPM-PRA's first case, its circles larger: three links in a wedge that closes (Table 1).
Family corridorFamily();

/// Links thread one gap between two obstacles.
Family slabFamily();

/// Links thread several gaps in a row at once.
Family tubeFamily();

/// The same, the second gap tilted.
Family bentTubeFamily();

/// Links among random circles.
Family circlesFamily();

/// Links among random obstacles of all kinds.
Family mixedFamily();

/// OMPL's kinematic chain in a horn with thick walls.
Family hornFamily();

/// HPPM-PRA's third case, its links cut into pieces (Table 3).
Family cutFamily();

/// A chain is carried through gaps, from one side of them to the other.
Family blindFamily();

/// A chain on a slide is fed into a planar maze.
Family gridMazeFamily();

/// A chain in space threads holes.
Family holesFamily();

/// An arm of six joints puts its tool into an opening.
Family slotFamily();

/// The arm of VDSM among pipes and prisms along its slide.
Family pipesFamily();

/// Chains fed through planar corridors with right-angle bends (tight maneuvering).
Family ladderFamily();

/// The same through a square duct: thirteen bends, or random ones.
Family mazeFamily();
Family ductFamily();

/// The same through a room full of boxes: always the same ones, or random ones.
Family boxesFamily();
Family clutterFamily();
}  // namespace narrows
