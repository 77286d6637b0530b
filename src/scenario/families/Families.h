// SPDX-License-Identifier: BSD-3-Clause
// The families, each with its parameters; see Family.h.
#pragma once

#include "scenario/families/Family.h"

namespace narrows
{
/// HPPM-PRA's first case, its circles larger: three links in a wedge that closes (Table 1).
Family corridorFamily();

/// Links thread one gap between two circles.
Family slabFamily();

/// Links thread several gaps in a row at once.
Family tubeFamily();

/// Links among random circles.
Family circlesFamily();

/// The arm of VDSM among pipes and prisms along its slide.
Family pipesFamily();
}  // namespace narrows
