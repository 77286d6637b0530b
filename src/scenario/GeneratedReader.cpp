// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/GeneratedReader.h"

#include <algorithm>

#include <fmt/format.h>

#include "scenario/MethodsReader.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
/// The family that the file names, or nothing (and a fault).
const Family *readFamily(const Mapping &generate)
{
    std::vector<std::string> names;
    for (const Family &family : families())
        names.push_back(family.name);
    const std::optional<std::string> name = generate.required("family").oneOf(names);
    return name ? &findFamily(*name) : nullptr;
}

/// The parameters as the file and the settings give them; faults for all that the family does not take.
FamilyValues readValues(const Mapping &generate, const Family &family, const GenerateSettings &settings)
{
    std::vector<std::string> known{"family"};
    for (const FamilyParameter &parameter : family.parameters)
        known.push_back(parameter.name);
    generate.allowOnly(known);
    FamilyValues values = family.values({});
    for (const FamilyParameter &parameter : family.parameters)
        if (const std::optional<std::string> text = generate.optional(parameter.name).text())
            try
            {
                values[parameter.name] = parameter.read(*text);
            }
            catch (const std::invalid_argument &error)
            {
                generate.optional(parameter.name).fault(error.what());
            }
    for (const auto &[name, text] : settings)
        try
        {
            values[name] = family.parameter(name).read(text);
        }
        catch (const std::invalid_argument &error)
        {
            generate.field().fault(fmt::format("{} = {}: {}", name, text, error.what()));
        }
    return values;
}

std::vector<std::string> obstacleNames(const Scenario &scenario)
{
    std::vector<std::string> names;
    const auto list = [&](const auto &world)
    {
        for (const auto &obstacle : world.model->obstacles)
            names.push_back(obstacle.name);
    };
    std::visit(list, scenario.world);
    return names;
}

std::string dumpMethods(const Field &methods)
{
    if (!methods.given())
        return "";
    YAML::Node entry;
    entry["methods"] = methods.node();
    return YAML::Dump(entry) + "\n";
}

/// What instances of one sweep that differ in their seeds only have in common.
GenerateSettings withoutSeed(GenerateSettings settings)
{
    settings.erase(
        std::remove_if(settings.begin(), settings.end(), [](const auto &setting) { return setting.first == "seed"; }),
        settings.end());
    return settings;
}
}  // namespace

std::string nameWith(const std::string &name, const GenerateSettings &settings)
{
    std::string result = name;
    for (const auto &[key, text] : settings)
        result += "_" + key + text;
    result.erase(std::remove(result.begin(), result.end(), '+'), result.end());
    return result;
}

void readGenerated(const Mapping &root, const GenerateSettings &settings, Scenario &scenario)
{
    FaultList &faults = root.field().faults();
    for (const char *made : {"robot", "obstacles", "start", "goal", "infeasible"})
        if (root.has(made))
            root.optional(made).fault("generate makes robot, obstacles, start and goal: leave it out");
    const Mapping generate(root.required("generate"));
    const Family *family = readFamily(generate);
    if (family == nullptr)
        return;
    const FamilyValues values = readValues(generate, *family, settings);
    if (faults.count() > 0)
        return;

    const std::string base = scenario.name;
    const std::string source = (scenario.source.empty() ? "" : scenario.source + "; ") + family->describe(values);
    try
    {
        const std::string text = toYaml(family->draw(values), nameWith(base, settings), source);
        scenario = parseScenario(text, generate.field().key() + " of " + base);
    }
    catch (const std::invalid_argument &error)
    {
        generate.field().fault(error.what());
        return;
    }
    scenario.base = base;
    scenario.group = nameWith(base, withoutSeed(settings));
    scenario.family = family->name;
    const Field methods = root.optional("methods");
    scenario.methods = readMethods(methods, obstacleNames(scenario), dimensionOf(scenario.world));
    scenario.text += dumpMethods(methods);
}
}  // namespace narrows
