// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/Scenario.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "scenario/InputText.h"
#include "scenario/MethodsReader.h"
#include "scenario/ObstacleReader.h"
#include "scenario/RobotReader.h"
#include "scenario/TaskCheck.h"
#include "scenario/TaskReader.h"
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

/// The parts of a file that belong to the robot's world, and the checks that need several of them.
void readWorld(const Mapping &root, const RobotDraft &robot, Scenario &scenario)
{
    if (root.has("generate"))
    {
        root.optional("generate")
            .fault(
                "families of scenarios are not supported by this version; give obstacles, "
                "start and goal");
        return;
    }
    const ObstaclesDraft obstacles = readObstacles(root.required("obstacles"));
    const Field start = root.required("start");
    const Field goal = root.required("goal");
    const std::optional<PlanarTask> task = readTask(start, goal, robot);
    scenario.methods = readMethods(root.optional("methods"), obstacles.names, robot.arm ? robot.arm->dimension() : 0);
    if (!task || obstacles.obstacles.size() != obstacles.names.size())
        return;
    scenario.task = *task;
    scenario.model = std::make_shared<const PlanarModel>(PlanarModel{*robot.arm, obstacles.obstacles});
    checkTaskIsFree(start, goal, *scenario.model, *task);
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

Scenario parseScenario(const std::string &text, const std::string &file)
{
    checkInputText(text, file);
    FaultList faults(file);
    const Mapping root(Field(faults, parseYaml(text, file), ""));
    root.allowOnly({"format", "name", "source", "robot", "obstacles", "start", "goal", "methods", "generate"});
    root.required("format").oneOf({"narrows/scenario/1"});
    Scenario scenario;
    scenario.text = text;
    scenario.name = readName(root.required("name"));
    if (root.has("source"))
        scenario.source = root.optional("source").text().value_or("");
    const RobotDraft robot = readRobot(root.required("robot"));
    scenario.convention = robot.convention;
    if (robot.supported)
        readWorld(root, robot, scenario);
    faults.throwIfAny();
    return scenario;
}

Scenario readScenario(const std::string &path)
{
    return parseScenario(readInputText(path), path);
}
}  // namespace narrows
