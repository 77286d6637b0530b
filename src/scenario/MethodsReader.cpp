// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/MethodsReader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
using Parameters = std::map<std::string, std::string>;

/// What the planner accepts, see HPPM::declareParameters(); here so that a fault is reported with its line.
const std::map<std::string, Interval> hppmNumbers = {{"strength", {-100.0, 100.0}},
                                                     {"radius", {1e-4, 1.0}},
                                                     {"lambda_min", {-10.0, -1e-3}},
                                                     {"lambda_max", {1.0, 10.0}},
                                                     {"max_step", {1e-4, 1.0}}};
constexpr int mostPoints = 200;
constexpr std::size_t mostNumbers = 1000;

/// The number as the file writes it, so that nothing is lost on its way to the planner.
std::string numberText(const Field &field)
{
    return field.number() ? field.node().Scalar() : std::string{};
}

std::string repulsionText(const Field &field, const std::vector<std::string> &obstacles)
{
    const Mapping repulsion(field);
    repulsion.allowOnly(obstacles);
    std::vector<std::string> values;
    for (const std::string &name : obstacles)
        values.push_back(numberText(repulsion.required(name)));
    return fmt::format("{}", fmt::join(values, ", "));
}

/// As many entries as a configuration has values.
std::vector<Field> entriesPerJoint(const Field &field, int dimension)
{
    const auto exact = static_cast<std::size_t>(dimension);
    return dimension > 0 ? field.items(exact, exact) : field.items(1, mostNumbers);
}

std::string vectorText(const Field &field, int dimension)
{
    std::vector<std::string> values;
    for (const Field &item : entriesPerJoint(field, dimension))
        values.push_back(numberText(item));
    return fmt::format("{}", fmt::join(values, ", "));
}

std::string rowsText(const Field &field, int dimension)
{
    std::vector<std::string> rows;
    for (const Field &item : entriesPerJoint(field, dimension))
        rows.push_back(vectorText(item, dimension));
    return fmt::format("{}", fmt::join(rows, "; "));
}

std::string boundText(const Field &field, const Interval &range)
{
    const std::optional<double> value = field.number();
    if (value && !(*value >= range.lower && *value <= range.upper))
        field.fault(fmt::format("must be from {} to {}, not {}", range.lower, range.upper, *value));
    return value ? field.node().Scalar() : std::string{};
}

/// The text of one parameter of HPPM; nothing if HPPM has no such parameter.
std::optional<std::string> hppmText(const Mapping::Entry &entry, const std::vector<std::string> &obstacles,
                                    int dimension)
{
    const Field &field = entry.value;
    if (entry.name == "repulsion")
        return repulsionText(field, obstacles);
    if (entry.name == "rows")
        return rowsText(field, dimension);
    if (entry.name == "direction")
        return vectorText(field, dimension);
    if (entry.name == "points_per_link")
        return fmt::format("{}", field.integer(1, mostPoints).value_or(1));
    if (entry.name == "orientation")
        return field.oneOf({"increasing", "decreasing"}).value_or("");
    if (entry.name == "poles")
        return field.oneOf({"points", "continuous"}).value_or("");
    if (entry.name == "form")
        return field.oneOf({"full", "plane"}).value_or("");
    const auto number = hppmNumbers.find(entry.name);
    return number != hppmNumbers.end() ? std::optional(boundText(field, number->second)) : std::nullopt;
}

Parameters readHppm(const Field &field, const std::vector<std::string> &obstacles, int dimension)
{
    std::vector<std::string> known = {"repulsion",   "rows", "direction", "points_per_link",
                                      "orientation", "form", "poles"};
    for (const auto &number : hppmNumbers)
        known.push_back(number.first);
    const Mapping hppm(field);
    hppm.allowOnly(known);
    if (hppm.has("rows") && hppm.has("direction"))
        hppm.optional("direction").fault("rows already fix the direction; give one of them");
    Parameters texts;
    for (const Mapping::Entry &entry : hppm.entries())
        if (const std::optional<std::string> text = hppmText(entry, obstacles, dimension))
            texts[entry.name] = *text;
    texts.emplace("search", "paper");  // what is prescribed is one curve
    return texts;
}

Parameters readOther(const Field &field)
{
    Parameters texts;
    const Mapping parameters(field);
    for (const Mapping::Entry &entry : parameters.entries())
        texts[entry.name] = entry.value.text().value_or("");
    return texts;
}
}  // namespace

std::map<std::string, Parameters> readMethods(const Field &field, const std::vector<std::string> &obstacles,
                                              int dimension)
{
    std::map<std::string, Parameters> methods;
    const Mapping planners(field);
    for (const Mapping::Entry &entry : planners.entries())
        methods[entry.name] =
            entry.name == "hppm" ? readHppm(entry.value, obstacles, dimension) : readOther(entry.value);
    return methods;
}
}  // namespace narrows
