// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <ompl/base/Planner.h>

#include "benchmark/Record.h"
#include "validity/CheckCounts.h"

namespace narrows
{
/// What one call of solve() returned and cost.
struct SolveMeasurement
{
    ob::PlannerStatus status;
    bool expired = false;  ///< the termination condition held when solve() ended
    double time = 0.0;     ///< wall seconds
    double cpuTime = 0.0;  ///< CPU seconds of all threads of the process
    std::uint64_t stateChecks = 0;
    std::uint64_t motionChecks = 0;
    std::uint64_t placements = 0;
    std::optional<Outcome> failure;  ///< Memory or Crash if solve() threw
    std::string failureText;
};

/// Calls solve() with both clocks around it and nothing else. Whatever it throws becomes a failure.
SolveMeasurement measureSolve(ob::Planner &planner, const ob::PlannerTerminationCondition &ptc,
                              const CheckCounts &counts);
}  // namespace narrows
