// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialModel.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// Reports a start or goal that touches obstacles, with the links and the obstacles by name, and a place
/// for a tip that lies inside an obstacle, or too near to it for the link that ends there, with all of its tolerance.
/// \param numbers what the file counts each of the arm's links as
void checkTaskIsFree(const Field &start, const Field &goal, const SpatialModel &model, const SpatialTask &task,
                     const std::vector<int> &numbers);
}  // namespace narrows
