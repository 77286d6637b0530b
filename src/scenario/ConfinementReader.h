// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "scenario/World.h"
#include "scenario/YamlField.h"
#include "validity/Confinement.h"

namespace narrows
{
/// The proof that a file gives under `infeasible`, once it has been checked; nothing if there is none, or (and a fault)
/// if it proves nothing.
std::optional<Confinement> readConfinement(const Field &field, const PlanarWorld &world);
}  // namespace narrows
