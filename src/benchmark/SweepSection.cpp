// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/SweepSection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/Text.h"

namespace narrows
{
namespace
{
double wholeNumber(const std::string &text, const std::string &range)
{
    const std::optional<double> value = toNumber(text);
    if (!value || std::abs(*value) > 1e9 || *value != std::floor(*value))
        throw std::invalid_argument("'" + range + "' is not a range of whole numbers like 1..20");
    return *value;
}

/// "0.1..0.2 by 0.05" as 0.1, 0.15, 0.2.
std::vector<std::string> stepped(const std::string &range, std::size_t dots, std::size_t by, int most)
{
    const std::optional<double> first = toNumber(trimmed(range.substr(0, dots)));
    const std::optional<double> last = toNumber(trimmed(range.substr(dots + 2, by - dots - 2)));
    const std::optional<double> step = toNumber(trimmed(range.substr(by + 4)));
    if (!first || !last || !step)
        throw std::invalid_argument("'" + range + "' is not a range of numbers like 0.1..0.2 by 0.05");
    const double steps = (*last - *first) / *step;
    if (!(*step > 0.0 && steps >= 0.0 && steps < most))
        throw std::invalid_argument("'" + range + "' is an empty or too large range");
    std::vector<std::string> values;
    constexpr double rounding = 1e-6;  // of a step
    for (int i = 0; i <= steps + rounding; ++i)
        values.push_back(fmt::format("{:.12g}", *first + i * *step));
    return values;
}

/// "3..5" as 3, 4, 5.
std::vector<std::string> unfolded(const std::string &range, std::size_t dots, int most)
{
    if (const std::size_t by = range.find(" by ", dots); by != std::string::npos)
        return stepped(range, dots, by, most);
    const double first = wholeNumber(trimmed(range.substr(0, dots)), range);
    const double last = wholeNumber(trimmed(range.substr(dots + 2)), range);
    if (last < first || last - first >= most)
        throw std::invalid_argument("'" + range + "' is an empty or too large range");
    std::vector<std::string> values;
    for (auto value = static_cast<long>(first); value <= static_cast<long>(last); ++value)
        values.push_back(std::to_string(value));
    return values;
}

/// \throws std::invalid_argument telling what is wrong
std::vector<std::string> readValues(const std::string &text, int most)
{
    std::vector<std::string> values;
    for (const std::string &part : split(text, ','))
    {
        if (part.empty())
            throw std::invalid_argument("expected a list separated by commas");
        const std::size_t dots = part.find("..");
        const std::vector<std::string> more =
            dots == std::string::npos ? std::vector<std::string>{part} : unfolded(part, dots, most);
        values.insert(values.end(), more.begin(), more.end());
    }
    if (values.empty())
        throw std::invalid_argument("expected a list separated by commas");
    std::vector<std::string> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
    if (twin != sorted.end())
        throw std::invalid_argument("names '" + *twin + "' twice");
    return values;
}

/// "maze.generate.links" as an axis of the scenario called maze, "generate.links" as one of all.
/// \throws std::invalid_argument telling what is wrong
SweepAxis readAxis(const IniEntry &entry, int most)
{
    const std::string word = "generate.";
    const std::size_t place = entry.key.rfind(word);
    const bool named = place != std::string::npos && place > 1 && entry.key[place - 1] == '.';
    if (place == std::string::npos || (place != 0 && !named) || place + word.size() == entry.key.size())
        throw std::invalid_argument(
            "unknown key; this section has generate.<parameter of the family> and <scenario>.generate.<parameter>");
    return {named ? entry.key.substr(0, place - 1) : "", entry.key.substr(place + word.size()),
            readValues(entry.value, most), entry.line};
}
}  // namespace

std::vector<SweepAxis> readSweepSection(const std::vector<IniEntry> &entries, const std::string &file, int mostScenes,
                                        std::vector<InputFault> &faults)
{
    std::vector<SweepAxis> axes;
    std::map<std::string, double> instances;  // by scenario
    for (const IniEntry &entry : entries)
        try
        {
            const SweepAxis axis = readAxis(entry, mostScenes);
            for (const SweepAxis &other : axes)
                if (other.parameter == axis.parameter && other.scenario == axis.scenario)
                    throw std::invalid_argument("already given in line " + std::to_string(other.line));
            double &count = instances.emplace(axis.scenario, 1.0).first->second;
            count *= static_cast<double>(axis.values.size());
            if (count > mostScenes)
                throw std::invalid_argument(fmt::format("makes more than {} instances", mostScenes));
            axes.push_back(axis);
        }
        catch (const std::invalid_argument &error)
        {
            faults.push_back({file, entry.line, "sweep." + entry.key, error.what()});
        }
    return axes;
}

std::vector<SweepAxis> axesOf(const std::string &scenario, const std::vector<SweepAxis> &axes)
{
    std::vector<SweepAxis> own, common;
    for (const SweepAxis &axis : axes)
        if (axis.scenario == scenario)
            own.push_back(axis);
        else if (axis.scenario.empty())
            common.push_back(axis);
    return own.empty() ? common : own;
}

std::vector<GenerateSettings> combinations(const std::vector<SweepAxis> &axes)
{
    std::vector<GenerateSettings> all{{}};
    for (const SweepAxis &axis : axes)
    {
        std::vector<GenerateSettings> longer;
        for (const GenerateSettings &settings : all)
            for (const std::string &value : axis.values)
            {
                longer.push_back(settings);
                longer.back().emplace_back(axis.parameter, value);
            }
        all = std::move(longer);
    }
    return all;
}
}  // namespace narrows
