// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <ompl/base/Planner.h>

#include "benchmark/PreparedRun.h"

namespace narrows
{
/// When solve() has to end: by the clock, or by a number of checks or evaluations, which is the same on any machine.
/// Counted from construction. It stays what it was for the copies of its condition.
class RunBudget
{
public:
    RunBudget(const RunSpec &spec, const PreparedRun &run);

    /// For solve(). Holds as soon as one of the limits is reached; for threads of the planner, too.
    const ob::PlannerTerminationCondition &condition() const { return condition_; }

    /// "state_check_limit" or "evaluation_limit" if that is reached, else empty.
    std::string reached() const;

private:
    struct Budget;

    std::shared_ptr<const Budget> budget_;  ///< null if only the clock limits the run
    ob::PlannerTerminationCondition condition_;
};
}  // namespace narrows
