// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/RunBudget.h"

#include <limits>

#include "benchmark/Judging.h"
#include "benchmark/SolveLimit.h"

namespace narrows
{
/// What the counters read when a limit is reached.
struct RunBudget::Budget
{
    std::shared_ptr<const CheckCounts> counts;
    ob::PlannerPtr planner;
    std::uint64_t lastStateCheck = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t lastEvaluation = std::numeric_limits<std::uint64_t>::max();

    std::uint64_t evaluations() const
    {
        return counts->placements + static_cast<std::uint64_t>(homotopyEvaluations(*planner));
    }
    bool stateChecksUsedUp() const { return counts->stateChecks >= lastStateCheck; }
    bool evaluationsUsedUp() const { return evaluations() >= lastEvaluation; }
};

namespace
{
/// OMPL's conditions with a function are polled in line: nothing but the planner's own course decides when.
ob::PlannerTerminationCondition either(const ob::PlannerTerminationCondition &clock, std::function<bool()> usedUp)
{
    return ob::plannerOrTerminationCondition(clock, ob::PlannerTerminationCondition(std::move(usedUp)));
}
}  // namespace

RunBudget::RunBudget(const RunSpec &spec, const PreparedRun &run) : condition_(solveLimit(spec.timeLimit))
{
    if (spec.stateCheckLimit == 0 && spec.evaluationLimit == 0)
        return;
    auto budget = std::make_shared<Budget>();
    budget->counts = run.problem.counts;
    budget->planner = run.planner;
    if (spec.stateCheckLimit > 0)
        budget->lastStateCheck = budget->counts->stateChecks + static_cast<std::uint64_t>(spec.stateCheckLimit);
    if (spec.evaluationLimit > 0)
        budget->lastEvaluation = budget->evaluations() + static_cast<std::uint64_t>(spec.evaluationLimit);
    budget_ = budget;
    condition_ = either(condition_, [budget] { return budget->stateChecksUsedUp() || budget->evaluationsUsedUp(); });
}

std::string RunBudget::reached() const
{
    if (!budget_)
        return {};
    if (budget_->stateChecksUsedUp())
        return "state_check_limit";
    return budget_->evaluationsUsedUp() ? "evaluation_limit" : "";
}
}  // namespace narrows
