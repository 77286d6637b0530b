// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/PlanarModel.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// What the file says of a robot in the plane, as far as it could be understood.
struct RobotDraft
{
    int linkCount = 0;  ///< links as listed, sound or not
    bool hasSlide = false;
    bool selfCollision = false;
    AngleConvention convention = AngleConvention::Absolute;
    JointLimits limits;            ///< complete only if there is an arm
    std::optional<PlanarArm> arm;  ///< only if nothing is wrong with the robot
};

RobotDraft readRobot(const Field &field);

/// Half-width of links: not negative, 0 if it is not given.
double readRadius(const Field &field);
}  // namespace narrows
