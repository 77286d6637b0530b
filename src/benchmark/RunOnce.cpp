// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/RunOnce.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include <ompl/geometric/PathSimplifier.h>
#include <ompl/util/Exception.h>

#include "benchmark/Judging.h"
#include "benchmark/PathTiming.h"
#include "benchmark/PreparedRun.h"
#include "benchmark/ProcessUsage.h"
#include "benchmark/QuietOmpl.h"
#include "benchmark/RunBudget.h"
#include "benchmark/SolveMeasurement.h"

namespace narrows
{
namespace
{
constexpr double simplificationLimit = 1.0;  // seconds; OMPL's simplifier is done in milliseconds as a rule

/// Solves the same problem with other seeds until the time is up or one fails, so that code, heap and caches are as in
/// a program that has been planning for a while.
void warmUp(const RunSpec &spec)
{
    // How often it says something depends on the clock; what a run says must not.
    const QuietOmpl silent(ompl::msg::LOG_NONE);
    constexpr std::uint32_t otherSeeds = 0x9e3779b9;
    const ob::PlannerTerminationCondition over = ob::timedPlannerTerminationCondition(spec.warmUp);
    try
    {
        for (std::uint32_t turn = 1; !over; ++turn)
        {
            seedOmpl(spec.seed ^ (otherSeeds * turn));
            const PreparedRun run = prepare(spec);
            if (!run.planner || !run.planner->solve(over))
                return;
        }
    }
    catch (...)
    {
        // What goes wrong here goes wrong again, or not, in the run that counts.
    }
}

void simplifySolution(const RunSpec &spec, const Problem &problem, og::PathGeometric &path, Record &record)
{
    og::PathSimplifier simplifier(problem.si);
    const double start = processCpuSeconds();
    try
    {
        simplifier.simplify(path, ob::timedPlannerTerminationCondition(simplificationLimit));
    }
    catch (const ompl::Exception &)
    {
        return;  // the simplifier's failure takes nothing from the solution; its columns stay empty
    }
    record.simplificationTime = processCpuSeconds() - start;
    judgeSimplified(spec, problem, path, record);
}

/// The run itself, between the stages; throws what building and judging throw.
void runStages(const RunSpec &spec, const std::function<void(RunStage)> &onStage, Record &record)
{
    // What the warm-up leaves in the allocator is used by the run, so the growth is counted from before the warm-up.
    const std::optional<double> residentBefore = residentKb();
    if (spec.warmUp > 0.0)
    {
        onStage(RunStage::WarmUp);
        warmUp(spec);
    }

    onStage(RunStage::Building);
    resetPeakResident();
    seedOmpl(spec.seed);
    const PreparedRun run = prepare(spec);
    if (!run.unsupported.empty())
    {
        record.outcome = Outcome::Unsupported;
        record.reason = run.unsupported;
        return;
    }
    record.parameters.clear();
    run.planner->params().getParams(record.parameters);

    onStage(RunStage::Solving);
    const RunBudget budget(spec, run);
    const SolveMeasurement measurement = measureSolve(*run.planner, budget.condition(), *run.problem.counts);

    onStage(RunStage::Judging);
    const std::optional<double> peak = peakResidentKb();
    if (residentBefore && peak)
        record.peakMemoryKb = std::max(0.0, *peak - *residentBefore);
    recordCosts(measurement, record);
    const std::shared_ptr<og::PathGeometric> path = copySolution(*run.problem.pdef);
    judge(spec, run.problem, *run.planner, measurement, path.get(), record);
    if (record.outcome == Outcome::Timeout && !budget.reached().empty())
        record.reason = budget.reached();
    if (!measurement.failure)
        recordPlannerData(spec, run.problem, *run.planner, record);
    recordTiming(spec, record);
    if (spec.simplify && record.outcome == Outcome::Solved)
        simplifySolution(spec, run.problem, *path, record);
}
}  // namespace

Record runOnce(const RunSpec &spec, const std::function<void(RunStage)> &onStage)
{
    const QuietOmpl quiet;
    Record record = announce(spec);
    try
    {
        runStages(
            spec, onStage ? onStage : [](RunStage) {}, record);
    }
    catch (const std::invalid_argument &)
    {
        throw;
    }
    catch (const std::bad_alloc &error)
    {
        record.outcome = Outcome::Memory;
        record.reason = error.what();
    }
    catch (const std::exception &error)
    {
        record.outcome = Outcome::Crash;
        record.reason = error.what();
    }
    catch (...)
    {
        record.outcome = Outcome::Crash;
        record.reason = "unknown exception";
    }
    return record;
}
}  // namespace narrows
