// SPDX-License-Identifier: BSD-3-Clause
// narrows generate: scenario files of a family.
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/Commands.h"
#include "benchmark/Text.h"
#include "scenario/GeneratedReader.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
struct GenerateOptions
{
    std::string family;
    std::vector<std::string> parameters;
    std::string name;
    std::string output;
    std::string witness;
};

/// A free path from start to goal; empty if none is known.
std::vector<Eigen::VectorXd> witnessOf(const Scene &scene)
{
    if (const auto *plane = std::get_if<ArmScene>(&scene))
        return plane->witness;
    const auto *space = std::get_if<SpaceScene>(&scene);
    return space != nullptr ? space->witness : std::vector<Eigen::VectorXd>{};
}

std::string witnessJson(const World &world, const std::vector<Eigen::VectorXd> &witness)
{
    nlohmann::json rows = nlohmann::json::array();
    for (const Eigen::VectorXd &configuration : witness)
    {
        const Eigen::VectorXd q = toFile(world, configuration);
        rows.push_back(std::vector<double>(q.begin(), q.end()));
    }
    return nlohmann::json{{"angles", rows}}.dump() + "\n";
}

int generate(const GenerateOptions &options)
{
    const GenerateSettings settings = assignments("--param", options.parameters);
    const Family &family = findFamily(options.family);
    const FamilyValues values = family.values({settings.begin(), settings.end()});
    const Scene scene = family.draw(values);
    const std::vector<Eigen::VectorXd> witness = witnessOf(scene);
    const std::string name = options.name.empty() ? nameWith(family.name, settings) : options.name;
    const std::string text = toYaml(scene, name, family.describe(values));
    const Scenario scenario = parseScenario(text, "--name");  // which is all that can be wrong with it
    if (!options.witness.empty() && witness.empty())
        throw std::invalid_argument(scenario.infeasible
                                        ? "--witness: the scene has no way"
                                        : "--witness: no witness is known for the family " + family.name);

    if (options.output.empty())
        std::cout << text;
    else
        writeFile(options.output, text);
    if (!options.witness.empty())
        writeFile(options.witness, witnessJson(scenario.world, witness));
    return ExitDone;
}
}  // namespace

void addGenerateCommand(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<GenerateOptions>();
    CLI::App *command = program.add_subcommand("generate", "Write a scenario file of a family");
    command->add_option("family", options->family, "see `narrows list families`")->required();
    command->add_option("--param", options->parameters, "name=value, may be repeated; see `narrows show family`")
        ->allow_extra_args(false);
    command->add_option("--name", options->name, "of the scenario; default: the family and the parameters given");
    command->add_option("-o,--output", options->output, "file to write; default: stdout");
    command->add_option("--witness", options->witness, "also write a free path, for `narrows verify`, if one is known");
    command->callback([options, &exitCode] { exitCode = generate(*options); });
}
}  // namespace narrows
