// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "scenario/SpatialRobotReader.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// Reads `joints`, and `slide`, of a start or goal. Nothing if the entry is not sound, or the robot is not.
/// \return one value per joint, slide first; checked against the robot's dimension and limits.
std::optional<Eigen::VectorXd> readSpatialState(const Mapping &entry, const SpatialRobotDraft &robot);
}  // namespace narrows
