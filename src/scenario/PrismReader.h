// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/SpatialModel.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// Reads an obstacle of kind prism; nothing (and faults) if it is not sound.
std::optional<Prism> readPrism(const Mapping &entry);
}  // namespace narrows
