// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/Planner.h>

#include "benchmark/Record.h"

namespace narrows
{
/// A planner in front of its problem, set up.
struct PreparedRun
{
    Problem problem;
    std::string unsupported;  ///< why this planner cannot do this problem; then there is no planner
    ob::PlannerPtr planner;
};

/// All parameters that the run gives its planner: the scenario's recipe, if the run may use it, under the experiment's.
std::map<std::string, std::string> givenParameters(const RunSpec &spec);

/// What is known of a run before it starts: who plans, with which parameters and whose knowledge.
/// \throws std::invalid_argument if there is no such planner.
Record announce(const RunSpec &spec);

/// Seeds OMPL. Only what is built afterwards depends on the seed alone. OMPL refuses 0; 2^32 - 1 stands for it.
void seedOmpl(std::uint32_t seed);

/// Path length that any solution satisfies: optimising planners stop at their first.
ob::OptimizationObjectivePtr firstSolution(const ob::SpaceInformationPtr &si);

/// Builds problem and planner.
/// \throws std::invalid_argument if the spec names things that do not exist or do not fit; whatever the planner throws.
PreparedRun prepare(const RunSpec &spec);
}  // namespace narrows
