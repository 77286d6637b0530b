// SPDX-License-Identifier: BSD-3-Clause
// narrows list, narrows show: what there is.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/BuildInfo.h"
#include "benchmark/Commands.h"
#include "benchmark/Metrics.h"
#include "planners/ParameterMeanings.h"
#include "planners/PlannerFactory.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
using Json = nlohmann::ordered_json;

/// Planners tell their parameters only once they exist, and they exist only for a problem.
constexpr const char *smallProblem = R"(format: narrows/scenario/1
name: two-links
robot:
  kind: planar_arm
  base: [0, 0]
  links: [{length: 1}, {length: 1}]
  angles: absolute
  limits: none
  radius: 0
obstacles:
  - {name: C, kind: circle, center: [0, 5], radius: 1}
start: {angles: [0, 0]}
goal: {angles: [1, 1]}
)";

/// The same for planners that only know robots in space.
constexpr const char *smallProblemInSpace = R"(format: narrows/scenario/1
name: two-links-in-space
robot:
  kind: spatial_arm
  joints: universal
  base: {origin: [0, 0, 0], slide: {axis: [1, 0, 0], limits: [-1, 1]}}
  links: [{length: 1}, {length: 1}]
  radius: 0.05
  max_link_angle: 40 deg
obstacles:
  - {name: C, kind: cylinder, axis: x, center: [0, 5, 0], radius: 1, length: inf}
start: {slide: 0, joints: [[0, 0], [0, 0]]}
goal: {tip: [2, 0.5, 0], tolerance: 0.001}
)";

/// One of the two that the planner can do, if it can do either.
Problem smallProblemFor(const std::string &planner)
{
    Problem inPlane = makeProblem(parseScenario(smallProblem, "built-in problem"));
    if (whyUnsupported(planner, inPlane.context).empty())
        return inPlane;
    Problem inSpace = makeProblem(parseScenario(smallProblemInSpace, "built-in problem"));
    return whyUnsupported(planner, inSpace.context).empty() ? inSpace : inPlane;
}

Json listPlanners()
{
    Json list = Json::array();
    for (const PlannerEntry &entry : planners())
        list.push_back({{"name", entry.name},
                        {"summary", entry.summary},
                        {"uses_model", entry.usesModel},
                        {"threaded", entry.threaded}});
    return list;
}

/// The scenarios that come with the program: from the sources if they are there, else as installed.
Json listScenarios()
{
    Json list = Json::array();
    for (const char *folder : {build::sourceFolder, build::shareFolder})
    {
        const auto scenarios = std::filesystem::path(folder) / "experiments" / "scenarios";
        if (!std::filesystem::is_directory(scenarios))
            continue;
        std::vector<std::filesystem::path> files;
        for (const auto &entry : std::filesystem::directory_iterator(scenarios))
            if (entry.path().extension() == ".yaml")
                files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const auto &file : files)
        {
            const Scenario scenario = readScenario(file.string());
            list.push_back({{"name", scenario.name}, {"file", file.string()}, {"source", scenario.source}});
        }
        return list;
    }
    return list;
}

Json listFamilies()
{
    Json list = Json::array();
    for (const Family &family : families())
    {
        std::vector<std::string> parameters;
        for (const FamilyParameter &parameter : family.parameters)
            parameters.push_back(parameter.name);
        list.push_back({{"name", family.name}, {"summary", family.summary}, {"parameters", parameters}});
    }
    return list;
}

Json listMetrics()
{
    Json list = Json::array();
    for (const Metric &metric : metrics())
        list.push_back({{"name", metric.name}, {"type", metric.type}, {"meaning", metric.meaning}});
    return list;
}

/// One line per object: its first value in a column of its own, then the others.
void printTable(const Json &list)
{
    std::size_t width = 0;
    for (const Json &item : list)
        width = std::max(width, item.front().get<std::string>().size());
    for (const Json &item : list)
    {
        std::string line;
        for (const auto &[key, value] : item.items())
        {
            if (line.empty())
                line = fmt::format("{:<{}}", value.get<std::string>(), width);
            else if (value.is_string())
                line += "  " + value.get<std::string>();
            else if (value == true)
                line += " (" + key + ")";
        }
        std::cout << line << "\n";
    }
}

Json describePlanner(const std::string &name)
{
    const PlannerEntry &entry = findPlanner(name);
    const Problem problem = smallProblemFor(name);
    const ob::PlannerPtr planner = entry.make(problem.context);  // also of those that can plan nothing
    Json parameters = Json::array();
    for (const auto &[parameter, value] : planner->params().getParams())
        parameters.push_back({{"name", parameter},
                              {"default", value->getValue()},
                              {"range", value->getRangeSuggestion()},
                              {"meaning", parameterMeaning(name, parameter)}});
    return {{"name", name},
            {"summary", entry.summary},
            {"uses_model", entry.usesModel},
            {"threaded", entry.threaded},
            {"parameters", parameters}};
}

Json describeFamily(const std::string &name)
{
    const Family &family = findFamily(name);
    Json parameters = Json::array();
    for (const FamilyParameter &parameter : family.parameters)
        parameters.push_back(
            {{"name", parameter.name},
             {"default", parameter.standard ? Json(parameter.write(*parameter.standard)) : Json(nullptr)},
             {"range", parameter.range()},
             {"meaning", parameter.meaning}});
    return {{"name", name}, {"summary", family.summary}, {"parameters", parameters}};
}

void printFamily(const Json &family)
{
    std::cout << family["name"].get<std::string>() << ": " << family["summary"].get<std::string>() << "\n";
    for (const Json &parameter : family["parameters"])
    {
        const Json &standard = parameter["default"];
        std::cout << fmt::format("  {}{}   in {}: {}\n", parameter["name"].get<std::string>(),
                                 standard.is_null() ? "" : " = " + standard.get<std::string>(),
                                 parameter["range"].get<std::string>(), parameter["meaning"].get<std::string>());
    }
}

void printPlanner(const Json &planner)
{
    std::cout << planner["name"].get<std::string>() << ": " << planner["summary"].get<std::string>() << "\n";
    if (planner["uses_model"] == true)
        std::cout << "sees robot and obstacles, not only whether states are free\n";
    if (planner["threaded"] == true)
        std::cout << "plans with threads of its own: runs cannot be repeated exactly\n";
    for (const Json &parameter : planner["parameters"])
    {
        const auto range = parameter["range"].get<std::string>();
        const auto meaning = parameter["meaning"].get<std::string>();
        std::cout << fmt::format("  {} = {}{}{}\n", parameter["name"].get<std::string>(),
                                 parameter["default"].get<std::string>(), range.empty() ? "" : "   in " + range,
                                 meaning.empty() ? "" : ": " + meaning);
    }
}
}  // namespace

void addListCommands(CLI::App &program, int &exitCode)
{
    struct Options
    {
        std::string kind;
        std::string name;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *list = program.add_subcommand("list", "What there is: planners, scenarios, families, metrics");
    list->add_option("kind", options->kind)
        ->required()
        ->check(CLI::IsMember({"planners", "scenarios", "families", "metrics"}));
    list->add_flag("--json", options->json, "as JSON");
    list->callback(
        [options, &exitCode]
        {
            const Json all = options->kind == "planners"    ? listPlanners()
                             : options->kind == "scenarios" ? listScenarios()
                             : options->kind == "families"  ? listFamilies()
                                                            : listMetrics();
            if (options->json)
                std::cout << Json{{options->kind, all}}.dump(2) << "\n";
            else
                printTable(all);
            exitCode = ExitDone;
        });

    CLI::App *show =
        program.add_subcommand("show", "Details of a planner or a family: parameters, ranges and defaults");
    show->add_option("kind", options->kind)->required()->check(CLI::IsMember({"planner", "family"}));
    show->add_option("name", options->name, "see `narrows list planners` and `narrows list families`")->required();
    show->add_flag("--json", options->json, "as JSON");
    show->callback(
        [options, &exitCode]
        {
            const bool planner = options->kind == "planner";
            const Json thing = planner ? describePlanner(options->name) : describeFamily(options->name);
            if (options->json)
                std::cout << thing.dump(2) << "\n";
            else if (planner)
                printPlanner(thing);
            else
                printFamily(thing);
            exitCode = ExitDone;
        });
}
}  // namespace narrows
