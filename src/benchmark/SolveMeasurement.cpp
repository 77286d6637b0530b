// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/SolveMeasurement.h"

#include <chrono>
#include <new>

#include "benchmark/ProcessUsage.h"

namespace narrows
{
SolveMeasurement measureSolve(ob::Planner &planner, const ob::PlannerTerminationCondition &ptc,
                              const CheckCounts &counts)
{
    using Clock = std::chrono::steady_clock;
    SolveMeasurement result;
    const std::uint64_t stateChecks = counts.stateChecks;
    const std::uint64_t motionChecks = counts.motionChecks;
    const std::uint64_t placements = counts.placements;
    const Clock::time_point wallStart = Clock::now();
    const double cpuStart = processCpuSeconds();
    try
    {
        result.status = planner.solve(ptc);
    }
    catch (const std::bad_alloc &error)
    {
        result.failure = Outcome::Memory;
        result.failureText = error.what();
    }
    catch (const std::exception &error)
    {
        result.failure = Outcome::Crash;
        result.failureText = error.what();
    }
    catch (...)
    {
        result.failure = Outcome::Crash;
        result.failureText = "unknown exception";
    }
    result.cpuTime = processCpuSeconds() - cpuStart;
    result.time = std::chrono::duration<double>(Clock::now() - wallStart).count();
    result.expired = ptc;
    result.stateChecks = counts.stateChecks - stateChecks;
    result.motionChecks = counts.motionChecks - motionChecks;
    result.placements = counts.placements - placements;
    return result;
}
}  // namespace narrows
