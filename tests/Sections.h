// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/ConvexSection.h"

namespace narrows
{
/// What a pipe along the slide covers of the section plane.
inline ConvexSection disc(double y, double z, double radius)
{
    return ConvexSection({{y, z}}, radius);
}
}  // namespace narrows
