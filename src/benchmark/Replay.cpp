// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Replay.h"

#include <fmt/format.h>

#include "benchmark/IsolatedRunner.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
std::string textOf(const Cell &cell)
{
    if (const auto *integer = std::get_if<std::int64_t>(&cell))
        return fmt::format("{}", *integer);
    if (const auto *real = std::get_if<double>(&cell))
        return fmt::format("{}", *real);
    if (const auto *text = std::get_if<std::string>(&cell))
        return *text;
    return "NULL";
}

std::string describe(const std::vector<Eigen::VectorXd> &path)
{
    return fmt::format("{} waypoints", path.size());
}
}  // namespace

ReplayResult replay(const ResultStore &store, std::int64_t id)
{
    const StoredRun stored = store.run(id);
    ReplayResult result;
    result.spec = stored.spec;
    result.threaded = findPlanner(stored.spec.planner).threaded;
    runAll({stored.spec}, 1, [&](std::size_t, const Record &record) { result.record = record; });

    for (const Metric &metric : metrics())
    {
        const auto before = stored.cells.find(metric.name);  // an older program knew fewer
        if (isMeasured(metric) || before == stored.cells.end())
            continue;
        const Cell now = metric.value(result.spec, result.record);
        if (before->second != now)
            result.deviations.push_back({metric.name, textOf(before->second), textOf(now)});
    }
    if (!stored.path.empty() && stored.path != result.record.path)
        result.deviations.push_back({"path", describe(stored.path), describe(result.record.path)});
    return result;
}
}  // namespace narrows
