// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmark/ResultStore.h"

namespace narrows
{
/// An interval for a proportion; also of a sample, where the middle is its median.
struct Spread
{
    double lower;
    double middle;
    double upper;
};

/// Wilson's score interval for k successes in n trials, two-sided, 95 %. The middle is k / n.
/// \throws std::invalid_argument unless 0 <= k <= n and n > 0
Spread wilson(int k, int n);

/// Quartiles by linear interpolation between order statistics (type 7, numpy's default); nothing for an empty sample.
std::optional<Spread> quartiles(std::vector<double> sample);

/// One line of the table: a planner entry on the instances of one group.
struct SummaryRow
{
    std::string group;
    int instances = 0;          ///< of the group
    int solvableInstances = 0;  ///< of these, those that some planner entry of the campaign has solved
    std::string label;
    bool prescribed = false;
    int runs = 0;
    int solved = 0;
    Spread success{};  ///< 95 %
    // Over solved runs only; nothing if there are none.
    std::optional<Spread> cpuMilliseconds;
    std::optional<double> evaluations;
    std::optional<double> stateChecks;
    std::optional<double> length;
    std::optional<double> clearance;
    std::string
        failures;  ///< outcomes and reasons of the others, most frequent first: "timeout 3, no_solution (span) 1"
};

/// By group in the order given; within one, most solved first, then least median CPU time.
std::vector<SummaryRow> summarize(const std::vector<RunRow> &runs);

/// The table for a terminal, or as Markdown.
std::string summaryText(const std::vector<SummaryRow> &rows);
std::string summaryMarkdown(const std::vector<SummaryRow> &rows);
}  // namespace narrows
