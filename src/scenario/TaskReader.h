// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/PlanarModel.h"
#include "scenario/RobotReader.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// Reads start and goal and checks them against the robot alone: dimension, lengths, limits, reach.
/// Nothing if one of them, or the robot, is not sound.
std::optional<PlanarTask> readTask(const Field &start, const Field &goal, const RobotDraft &robot);
}  // namespace narrows
