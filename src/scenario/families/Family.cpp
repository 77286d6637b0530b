// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/Family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenario/FaultList.h"
#include "scenario/NumberText.h"
#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
template <typename Item>
const Item &find(const std::vector<Item> &items, const std::string &name, const std::string &what)
{
    std::vector<std::string> names;
    for (const Item &item : items)
    {
        if (item.name == name)
            return item;
        names.push_back(item.name);
    }
    std::string hint = suggestion(name, names);
    if (hint.empty())
    {
        for (const std::string &known : names)
            hint += (hint.empty() ? "; there are " : ", ") + known;
    }
    throw std::invalid_argument(fmt::format("there is no {} '{}'{}", what, name, hint));
}
}  // namespace

std::string FamilyParameter::range() const
{
    switch (kind)
    {
        case Kind::Flag:
            return "true, false";
        case Kind::Name:
            return fmt::format("{}", fmt::join(names, ", "));
        default:
            return fmt::format("{} to {}", lowest, highest);
    }
}

double FamilyParameter::read(const std::string &text) const
{
    if (kind == Kind::Name)
    {
        const auto found = std::find(names.begin(), names.end(), text);
        if (found != names.end())
            return static_cast<double>(found - names.begin());
        throw std::invalid_argument(fmt::format("must be one of {}, not '{}'", range(), text));
    }
    if (kind == Kind::Flag)
    {
        if (text == "true" || text == "false")
            return text == "true" ? 1.0 : 0.0;
        throw std::invalid_argument(fmt::format("must be true or false, not '{}'", text));
    }
    const std::optional<double> value = parseNumber(text);
    const bool fits = value && *value >= lowest && *value <= highest;  // false for NaN too
    if (fits && (kind == Kind::Real || *value == std::floor(*value)))
        return *value;
    throw std::invalid_argument(fmt::format("must be a {} from {} to {}, not '{}'",
                                            kind == Kind::Whole ? "whole number" : "number", lowest, highest, text));
}

std::string FamilyParameter::write(double value) const
{
    if (kind == Kind::Flag)
        return value != 0.0 ? "true" : "false";
    if (kind == Kind::Name)
        return names.at(static_cast<std::size_t>(value));
    return fmt::format("{}", value);
}

const FamilyParameter &Family::parameter(const std::string &key) const
{
    return find(parameters, key, "parameter of the family " + name);
}

FamilyValues Family::values(const std::map<std::string, std::string> &given) const
{
    FamilyValues values;
    for (const FamilyParameter &parameter : parameters)
        if (parameter.standard)
            values[parameter.name] = *parameter.standard;
    for (const auto &[key, text] : given)
        try
        {
            values[key] = parameter(key).read(text);
        }
        catch (const std::invalid_argument &error)
        {
            throw std::invalid_argument(fmt::format("{}: {}", key, error.what()));
        }
    return values;
}

std::string Family::describe(const FamilyValues &values) const
{
    std::string text;
    for (const FamilyParameter &parameter : parameters)
        if (const auto value = values.find(parameter.name); value != values.end())
            text += fmt::format("{}{} {}", text.empty() ? ": " : ", ", parameter.name, parameter.write(value->second));
    return name + text;
}

std::string toYaml(const Scene &scene, const std::string &name, const std::string &source)
{
    return std::visit([&](const auto &one) { return toYaml(one, name, source); }, scene);
}

const std::vector<Family> &families()
{
    static const std::vector<Family> all{
        bentTubeFamily(), blindFamily(), boxesFamily(),    circlesFamily(), clutterFamily(), corridorFamily(),
        cutFamily(),      ductFamily(),  gridMazeFamily(), holesFamily(),   hornFamily(),    ladderFamily(),
        mazeFamily(),     mixedFamily(), pipesFamily(),    slabFamily(),    slotFamily(),    tubeFamily()};
    return all;
}

const Family &findFamily(const std::string &name)
{
    return find(families(), name, "family");
}
}  // namespace narrows
