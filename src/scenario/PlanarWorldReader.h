// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenario/Scenario.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// Fills in `world` and `methods` from the file's robot, obstacles, start, goal and methods. What is wrong with them is
/// reported, and the world is complete only if nothing is.
void readPlanarWorld(const Mapping &root, Scenario &scenario);
}  // namespace narrows
