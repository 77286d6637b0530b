// SPDX-License-Identifier: BSD-3-Clause
// How a summary looks, on a terminal and in Markdown.
#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "benchmark/Summary.h"

namespace narrows
{
namespace
{
constexpr const char *header =
    "CPU time, evaluations, checks, length and clearance: medians over solved runs only "
    "[quartiles]. Success: 95 % Wilson interval.";
constexpr const char *footnote = "* uses the recipe prescribed for this scenario: knowledge the others do not get";

using Line = std::vector<std::string>;

const Line titles{"planner",      "solved",    "success [95 %]", "CPU ms [quartiles]", "evaluations", "state checks",
                  "length (rad)", "clearance", "failures"};

std::string cell(const std::optional<double> &value, const char *format)
{
    return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string cell(const std::optional<Spread> &spread)
{
    return spread ? fmt::format("{:.3g} [{:.3g}, {:.3g}]", spread->middle, spread->lower, spread->upper) : "-";
}

Line cells(const SummaryRow &row)
{
    return {row.label + (row.prescribed ? " *" : ""),
            fmt::format("{}/{}", row.solved, row.runs),
            fmt::format("{:.0f} % [{:.0f}, {:.0f}]", 100 * row.success.middle, 100 * row.success.lower,
                        100 * row.success.upper),
            cell(row.cpuMilliseconds),
            cell(row.evaluations, "{:.0f}"),
            cell(row.stateChecks, "{:.0f}"),
            cell(row.length, "{:.2f}"),
            cell(row.clearance, "{:.3g}"),
            row.failures.empty() ? "-" : row.failures};
}

bool anyPrescribed(const std::vector<SummaryRow> &rows)
{
    return std::any_of(rows.begin(), rows.end(), [](const SummaryRow &row) { return row.prescribed; });
}

/// "slab_half_width0.01_analytic", or with "(20 instances, 19 of them solved by some planner)" behind it.
std::string title(const SummaryRow &row)
{
    if (row.instances == 1)
        return row.group;
    return fmt::format("{} ({} instances, {} of them solved by some planner)", row.group, row.instances,
                       row.solvableInstances);
}

/// Calls `write(title, lines)` for each group.
void eachGroup(const std::vector<SummaryRow> &rows,
               const std::function<void(const std::string &, const std::vector<Line> &)> &write)
{
    for (std::size_t i = 0; i < rows.size();)
    {
        const SummaryRow &first = rows[i];
        std::vector<Line> lines;
        for (; i < rows.size() && rows[i].group == first.group; ++i)
            lines.push_back(cells(rows[i]));
        write(title(first), lines);
    }
}

std::string padded(const Line &line, const std::vector<std::size_t> &widths)
{
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i)
        text += i == 0                 ? fmt::format("{:<{}}", line[i], widths[i])
                : i + 1 == line.size() ? "  " + line[i]
                                       : fmt::format("  {:>{}}", line[i], widths[i]);
    return text + "\n";
}
}  // namespace

std::string summaryText(const std::vector<SummaryRow> &rows)
{
    std::vector<std::size_t> widths(titles.size());
    const auto widen = [&](const Line &line)
    {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], line[i].size());
    };
    widen(titles);
    for (const SummaryRow &row : rows)
        widen(cells(row));
    std::string text = std::string(header) + "\n";
    eachGroup(rows,
              [&](const std::string &name, const std::vector<Line> &lines)
              {
                  text += "\n" + name + "\n" + padded(titles, widths);
                  for (const Line &line : lines)
                      text += padded(line, widths);
              });
    return text + (anyPrescribed(rows) ? std::string("\n") + footnote + "\n" : "");
}

std::string summaryMarkdown(const std::vector<SummaryRow> &rows)
{
    // In Markdown a lone * would begin emphasis and a | a new column.
    const auto tableRow = [](const Line &line)
    {
        std::string text = "|";
        for (const std::string &part : line)
        {
            text += " ";
            for (const char c : part)
                text += c == '*' || c == '|' ? std::string("\\") + c : std::string(1, c);
            text += " |";
        }
        return text + "\n";
    };
    std::string text = std::string(header) + "\n";
    eachGroup(rows,
              [&](const std::string &name, const std::vector<Line> &lines)
              {
                  text +=
                      "\n### " + name + "\n\n" + tableRow(titles) + "|---|---:|---:|---:|---:|---:|---:|---:|---|\n";
                  for (const Line &line : lines)
                      text += tableRow(line);
              });
    return text + (anyPrescribed(rows) ? std::string("\n\\") + footnote + "\n" : "");
}
}  // namespace narrows
