// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "kernel/PlanarArm.h"
#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Robot and obstacles: all that a white-box planner may see and a sampling planner may not.
struct PlanarModel
{
    PlanarArm arm;                          ///< the robot
    std::vector<PlanarObstacle> obstacles;  ///< closed sets, which may overlap
    bool selfCollision = false;             ///< links that do not meet at a joint must not touch each other
};

/// Permitted values of one joint; lower < upper.
struct Interval
{
    double lower;  ///< radians; a slide: length
    double upper;  ///< likewise
};

/// Limits of the joint angles, meant in one convention; joints without an interval turn freely.
struct JointLimits
{
    AngleConvention convention = AngleConvention::Absolute;  ///< what `angles` are counted in
    std::vector<std::optional<Interval>> angles;             ///< one per link
};

/// A goal that only fixes where the tip of one link shall be.
struct TipGoal
{
    int link;               ///< index of the link whose tip is meant
    Eigen::Vector2d point;  ///< where the tip shall be
    double tolerance;       ///< > 0, a distance
};

/// What is asked of the arm. Configurations are absolute angles (slide first).
struct PlanarTask
{
    Eigen::VectorXd start;                        ///< a configuration
    std::variant<Eigen::VectorXd, TipGoal> goal;  ///< a configuration, or where a tip shall be
    JointLimits limits;                           ///< of the angles; the slide has its own
};
}  // namespace narrows
