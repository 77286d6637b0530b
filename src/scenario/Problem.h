// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>

#include "planners/PlannerFactory.h"
#include "scenario/Scenario.h"
#include "spaces/ArmStateSpace.h"
#include "validity/CheckCounts.h"

namespace narrows
{
/// How a scenario is put before a planner. The texts are those of experiment files.
struct ProblemOptions
{
    std::string checker = "analytic";   ///< analytic | fcl
    std::string motion = "continuous";  ///< continuous | OMPL's resolution in (0, 1), e.g. "0.01"
    /// absolute | relative (joints without limits wrap) | absolute_line | relative_line (they do not) | scenario: the
    /// convention in which the scenario file counts its angles, wrapping. Robots in space have no absolute angles
    std::string space = "scenario";
};

/// Everything of one run, built anew for it.
struct Problem
{
    std::shared_ptr<ArmStateSpace> space;  ///< the joint space, as the options ask for
    ob::SpaceInformationPtr si;            ///< set up
    PlannerContext context;                ///< what planners are made from
    ob::ProblemDefinitionPtr pdef;         ///< start and goal
    std::shared_ptr<CheckCounts> counts;   ///< how often the checker and the validator have been asked
};

/// \throws std::invalid_argument if an option has no such value or does not fit the scenario (joint limits are kept
/// only by a space in their own convention).
Problem makeProblem(const Scenario &scenario, const ProblemOptions &options = {});
}  // namespace narrows
