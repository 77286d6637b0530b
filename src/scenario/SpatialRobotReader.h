// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kernel/SpatialArm.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// What the file says of a robot of kind spatial_arm, as far as it could be understood.
struct SpatialRobotDraft
{
    int entryCount = 0;             ///< entries of `links`, sound or not
    std::optional<bool> universal;  ///< two joint values per entry, pitch and yaw; else one; nothing if it is unclear
    bool hasSlide = false;
    bool selfCollision = false;
    std::optional<SpatialArm> arm;  ///< only if nothing is wrong with the robot
    std::vector<int> tips;          ///< per entry the arm's link that ends there; -1 if the entry has no length
    std::vector<int> numbers;       ///< per link of the arm, the number of its entry, from 1
};

/// True iff the file says that the robot lives in space; nothing is reported.
bool isSpatialRobot(const Field &field);

SpatialRobotDraft readSpatialRobot(const Field &field);
}  // namespace narrows
