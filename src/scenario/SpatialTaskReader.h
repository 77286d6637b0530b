// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/SpatialModel.h"
#include "scenario/SpatialRobotReader.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// Reads start and goal and checks them against the robot alone: dimension, limits, reach.
/// Nothing if one of them, or the robot, is not sound.
std::optional<SpatialTask> readSpatialTask(const Field &start, const Field &goal, const SpatialRobotDraft &robot);
}  // namespace narrows
