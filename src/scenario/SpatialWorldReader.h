// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scenario/Scenario.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// The counterpart of readPlanarWorld() for a robot in space. Meshes that are read from files of their own are added to
/// the scenario's text.
/// \param file the scenario's own name, which names of meshes are relative to
void readSpatialWorld(const Mapping &root, const std::string &file, Scenario &scenario);
}  // namespace narrows
