// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

#include "kernel/PlanarModel.h"
#include "kernel/Repulsion.h"
#include "kernel/SpatialModel.h"
#include "spaces/Ompl.h"

namespace narrows
{
/// What a planner may be made from. Sampling planners are given only `si`.
struct PlannerContext
{
    ob::SpaceInformationPtr si;  ///< what OMPL's planners are made from
    /// Makes the poles of the robot and the obstacles, which takes time and memory that only those who ask for them
    /// shall spend. Unset: nothing is known but `si`.
    std::function<std::shared_ptr<const RepulsionModel>()> repulsion;
    std::shared_ptr<const PlanarModel> planar;    ///< for planners of planar arms only; null for other robots
    std::shared_ptr<const SpatialModel> spatial;  ///< for planners of robots in space only; null for others
    bool tipPath =
        false;  ///< the problem's goal is a TipPathGoal: who does not follow one is led through it leg by leg
};

/// A planner in the table.
struct PlannerEntry
{
    std::string name;             ///< OMPL's class name in lower case, or ours
    std::string summary;          ///< one line: what it does, whose it is
    bool usesModel = false;       ///< needs PlannerContext::repulsion and the like
    bool threaded = false;        ///< plans with threads of its own, so that runs cannot be repeated exactly
    bool followsTipPath = false;  ///< reaches all points of a tip path by itself; others get it leg by leg
    /// A new planner with its defaults.
    std::function<ob::PlannerPtr(const PlannerContext &)> make;
    /// Empty if the planner can work in this space, else why not. May be unset: then it can work in all.
    std::function<std::string(const PlannerContext &)> unsupported;
};

/// All planners, OMPL's and ours, sorted by name.
const std::vector<PlannerEntry> &planners();

/// Adds a planner to the table (tests, plugins).
/// \throws std::invalid_argument if the name is taken.
void registerPlanner(PlannerEntry entry);

/// \throws std::invalid_argument if there is no such planner; the message lists near names.
const PlannerEntry &findPlanner(const std::string &name);

/// Why a planner cannot work in a space; empty if it can.
/// \throws std::invalid_argument if there is no such planner.
std::string whyUnsupported(const std::string &name, const PlannerContext &context);

/// Why a parameter could not be set.
class ParameterError : public std::invalid_argument
{
public:
    using std::invalid_argument::invalid_argument;
};

/// Makes a planner and sets its parameters (texts, as OMPL's ParamSet takes them). For a tip path, one that does not
/// follow it by itself comes as a LegByLeg, with the same parameters.
/// \throws std::invalid_argument for an unknown name, or if whyUnsupported() says something; ParameterError naming the
/// parameter if the planner has none of that name or refuses the value.
ob::PlannerPtr makePlanner(const std::string &name, const PlannerContext &context,
                           const std::map<std::string, std::string> &parameters = {});
}  // namespace narrows
