// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/SolveLimit.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "benchmark/ProcessUsage.h"

namespace narrows
{
ob::PlannerTerminationCondition solveLimit(double seconds)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const auto after = [begin](double wall)
    {
        return begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wall));
    };
    const double lastCpu = processCpuSeconds() + seconds;
    // The CPU's clock takes a call of the kernel, a microsecond or two: as much as some planners' iterations. It is not
    // asked before so much CPU time can have been used at all.
    const Clock::time_point first = after(seconds / std::max(1U, std::thread::hardware_concurrency()));
    const Clock::time_point last = after(wallLimit(seconds));
    return ob::PlannerTerminationCondition(
        [=]
        {
            const Clock::time_point now = Clock::now();
            return now >= first && (processCpuSeconds() >= lastCpu || now >= last);
        });
}

double wallLimit(double seconds)
{
    constexpr double mostWallPerCpu = 4.0;
    return mostWallPerCpu * seconds;
}
}  // namespace narrows
