// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/Scenario.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "scenario/GeneratedReader.h"
#include "scenario/InputText.h"
#include "scenario/PlanarWorldReader.h"
#include "scenario/SpatialRobotReader.h"
#include "scenario/SpatialWorldReader.h"
#include "scenario/YamlDocument.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
std::string joined(const std::vector<InputFault> &faults)
{
    std::string text;
    for (const InputFault &fault : faults)
        text += (text.empty() ? "" : "\n") + fault.text();
    return text;
}

/// One word, because benchmark databases and file names are made of it.
std::string readName(const Field &field)
{
    constexpr std::size_t longest = 100;
    const std::string name = field.text().value_or("");
    const auto isPartOfWord = [](char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
    };
    if (!std::all_of(name.begin(), name.end(), isPartOfWord) || name.size() > longest)
        field.fault(fmt::format("must be one word of at most {} letters, digits, '-', '_' and '.'", longest));
    return name;
}
}  // namespace

std::string InputFault::text() const
{
    std::string text = file + ":";
    if (line > 0)
        text += fmt::format("{}:", line);
    return text + " " + (key.empty() ? "" : key + ": ") + reason;
}

InputError::InputError(std::vector<InputFault> faults) : std::runtime_error(joined(faults)), faults_(std::move(faults))
{
}

Scenario parseScenario(const std::string &text, const std::string &file, const GenerateSettings &settings)
{
    checkInputText(text, file);
    FaultList faults(file);
    const Mapping root(Field(faults, parseYaml(text, file), ""));
    root.allowOnly({"format", "name", "source", "robot", "obstacles", "start", "goal", "infeasible", "methods",
                    "generate", "files"});
    root.required("format").oneOf({"narrows/scenario/1"});
    Scenario scenario;
    scenario.text = text;
    scenario.name = readName(root.required("name"));
    if (root.has("source"))
        scenario.source = root.optional("source").text().value_or("");
    scenario.base = scenario.group = scenario.name;
    const bool isSpatial = isSpatialRobot(root.optional("robot"));
    if (root.has("files") && !isSpatial)
        root.optional("files").fault("only robots of kind spatial_arm have obstacles from files");
    if (root.has("infeasible") && isSpatial)
        root.optional("infeasible").fault("proofs are known for robots in the plane only");
    if (root.has("generate"))
        readGenerated(root, settings, scenario);
    else if (!settings.empty())
        root.required("generate");
    else if (isSpatial)
        readSpatialWorld(root, file, scenario);
    else
        readPlanarWorld(root, scenario);
    faults.throwIfAny();
    return scenario;
}

Scenario readScenario(const std::string &path, const GenerateSettings &settings)
{
    return parseScenario(readInputText(path), path, settings);
}
}  // namespace narrows
