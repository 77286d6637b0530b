// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "scenario/RobotReader.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
/// Reads `angles` or `points`, and `slide`, of a start or goal. Nothing if the entry is not sound, or the robot is not.
/// \return absolute angles, slide first; checked against the robot's dimension, link lengths and limits.
std::optional<Eigen::VectorXd> readState(const Mapping &entry, const RobotDraft &robot);
}  // namespace narrows
