// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarModel.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// Reports a start or goal that touches obstacles, with the links and the obstacles by name, and a tip goal that lies
/// inside an obstacle with all of its tolerance.
void checkTaskIsFree(const Field &start, const Field &goal, const PlanarModel &model, const PlanarTask &task);
}  // namespace narrows
