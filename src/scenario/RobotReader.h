// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/PlanarModel.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// What the file says of the robot, as far as it could be understood.
struct RobotDraft
{
    bool supported = true;  ///< false: the rest of the file cannot be judged
    int linkCount = 0;      ///< links as listed, sound or not
    bool hasSlide = false;
    AngleConvention convention = AngleConvention::Absolute;
    JointLimits limits;            ///< complete only if there is an arm
    std::optional<PlanarArm> arm;  ///< only if nothing is wrong with the robot
};

RobotDraft readRobot(const Field &field);
}  // namespace narrows
