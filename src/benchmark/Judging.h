// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/geometric/PathGeometric.h>

#include "benchmark/Record.h"
#include "benchmark/SolveMeasurement.h"

namespace narrows
{
/// Writes times and counts into the record.
void recordCosts(const SolveMeasurement &measurement, Record &record);

/// Evaluations of a homotopy that a planner of ours has made since clear(); 0 for all others.
std::int64_t homotopyEvaluations(const ob::Planner &planner);

/// Decides how the run ended: only EXACT_SOLUTION is a claim, and the verifier has the last word on it. A path short of
/// the goal counts as Approximate if the planner stopped by itself, as Timeout if the limit stopped it. A planner that
/// gave up before the limit found NoSolution, even if it calls that a timeout (as OMPL's planners do).
/// \param path the planner's solution as it left solve(); may be null
void judge(const RunSpec &spec, const Problem &problem, const ob::Planner &planner, const SolveMeasurement &measurement,
           const og::PathGeometric *path, Record &record);

/// What the verifier says of a path that was derived from a solution, and its length. The path is not kept.
void judgeSimplified(const RunSpec &spec, const Problem &problem, const og::PathGeometric &path, Record &record);

/// The planner's graph sizes and, for planners of ours, their own measures, recipe and vias.
void recordPlannerData(const RunSpec &spec, const Problem &problem, const ob::Planner &planner, Record &record);

/// A copy of the solution that the planner left in the problem definition; null without one.
std::shared_ptr<og::PathGeometric> copySolution(const ob::ProblemDefinition &pdef);
}  // namespace narrows
