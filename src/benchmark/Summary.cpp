// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "benchmark/Text.h"

namespace narrows
{
namespace
{
/// The values of the solved runs.
std::vector<double> collect(const std::vector<RunRow> &runs, std::optional<double> RunRow::*member)
{
    std::vector<double> values;
    for (const RunRow &run : runs)
        if (run.outcome == Outcome::Solved && run.*member)
            values.push_back(*(run.*member));
    return values;
}

std::optional<double> median(const std::vector<RunRow> &runs, std::optional<double> RunRow::*member)
{
    const std::optional<Spread> spread = quartiles(collect(runs, member));
    return spread ? std::optional<double>(spread->middle) : std::nullopt;
}

/// A reason without its particulars: "collision: segment 3 at 0.5, ..." is a collision.
std::string kind(const std::string &reason)
{
    constexpr std::size_t longest = 40;  // exception texts have no bound
    const std::string line = reason.substr(0, reason.find('\n'));
    return line.substr(0, std::min(line.find(": "), longest));
}

std::string failures(const std::vector<RunRow> &runs)
{
    std::map<std::string, int> counts;
    for (const RunRow &run : runs)
        if (run.outcome != Outcome::Solved)
        {
            const std::string reason = kind(run.reason);
            ++counts[toString(run.outcome) + (reason.empty() ? "" : " (" + reason + ")")];
        }
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto &[name, count] : counts)
        sorted.emplace_back(-count, name);
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::string> parts;
    for (const auto &[count, name] : sorted)
        parts.push_back(name + " " + std::to_string(-count));
    return joined(parts, ", ");
}

SummaryRow summarizeEntry(const std::vector<RunRow> &runs)
{
    SummaryRow row;
    row.group = runs.front().group;
    row.label = runs.front().label;
    row.runs = static_cast<int>(runs.size());
    for (const RunRow &run : runs)
    {
        row.solved += run.outcome == Outcome::Solved ? 1 : 0;
        row.prescribed = row.prescribed || run.prescribed;
    }
    row.success = wilson(row.solved, row.runs);
    row.cpuMilliseconds = quartiles(collect(runs, &RunRow::cpuTime));
    if (row.cpuMilliseconds)
        for (double *seconds : {&row.cpuMilliseconds->lower, &row.cpuMilliseconds->middle, &row.cpuMilliseconds->upper})
            *seconds *= 1e3;
    row.evaluations = median(runs, &RunRow::evaluations);
    row.stateChecks = median(runs, &RunRow::stateChecks);
    row.length = median(runs, &RunRow::length);
    row.clearance = median(runs, &RunRow::clearance);
    row.failures = failures(runs);
    return row;
}

bool better(const SummaryRow &a, const SummaryRow &b)
{
    if (a.success.middle != b.success.middle)
        return a.success.middle > b.success.middle;
    return a.cpuMilliseconds && (!b.cpuMilliseconds || a.cpuMilliseconds->middle < b.cpuMilliseconds->middle);
}
}  // namespace

Spread wilson(int k, int n)
{
    if (k < 0 || k > n || n < 1)
        throw std::invalid_argument("wilson: " + std::to_string(k) + " of " + std::to_string(n) + " is no proportion");
    constexpr double z = 1.959963984540054;  // the normal distribution's 97.5 % quantile
    const double count = n;
    const double p = k / count;
    const double center = (p + z * z / (2 * count)) / (1 + z * z / count);
    const double half = z / (1 + z * z / count) * std::sqrt(p * (1 - p) / count + z * z / (4 * count * count));
    return {k == 0 ? 0.0 : center - half, p, k == n ? 1.0 : center + half};
}

std::optional<Spread> quartiles(std::vector<double> sample)
{
    if (sample.empty())
        return std::nullopt;
    std::sort(sample.begin(), sample.end());
    const auto quantile = [&](double p)
    {
        const double position = p * static_cast<double>(sample.size() - 1);
        const auto below = static_cast<std::size_t>(position);
        const std::size_t above = std::min(below + 1, sample.size() - 1);
        return sample[below] + (position - static_cast<double>(below)) * (sample[above] - sample[below]);
    };
    return Spread{quantile(0.25), quantile(0.5), quantile(0.75)};
}

std::vector<SummaryRow> summarize(const std::vector<RunRow> &runs)
{
    struct Group
    {
        std::map<std::string, bool> instances;  ///< and whether they were solved
        std::map<std::pair<std::string, std::string>, std::vector<RunRow>> entries;
    };
    std::vector<std::string> names;
    std::map<std::string, Group> groups;
    for (const RunRow &run : runs)
    {
        if (groups.count(run.group) == 0)
            names.push_back(run.group);
        Group &group = groups[run.group];
        bool &solved = group.instances[run.instance];
        solved = solved || run.outcome == Outcome::Solved;
        group.entries[{run.label, run.settings}].push_back(run);
    }
    std::vector<SummaryRow> rows;
    for (const std::string &name : names)
    {
        const Group &group = groups[name];
        const auto begin = static_cast<std::ptrdiff_t>(rows.size());
        for (const auto &[planner, entry] : group.entries)
        {
            rows.push_back(summarizeEntry(entry));
            rows.back().instances = static_cast<int>(group.instances.size());
            for (const auto &[instance, solved] : group.instances)
                rows.back().solvableInstances += solved ? 1 : 0;
        }
        std::stable_sort(rows.begin() + begin, rows.end(), better);
    }
    return rows;
}
}  // namespace narrows
