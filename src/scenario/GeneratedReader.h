// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scenario/Scenario.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// Fills in all of the scenario but its own name and source from the file's `generate` and `methods`; `text` becomes
/// the scenario file without `generate` that they stand for. What is wrong is reported. \param settings values that
/// replace those of `generate`; they become part of the scenario's name
void readGenerated(const Mapping &root, const GenerateSettings &settings, Scenario &scenario);

/// "slab", {half_width = 0.01, seed = 3}: "slab_half_width0.01_seed3". One word if the settings are numbers or words.
std::string nameWith(const std::string &name, const GenerateSettings &settings);
}  // namespace narrows
