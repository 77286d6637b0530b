// SPDX-License-Identifier: BSD-3-Clause
// narrows verify, narrows recheck: second opinions on paths.
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "benchmark/Commands.h"
#include "benchmark/PathFile.h"
#include "benchmark/Recheck.h"

namespace narrows
{
namespace
{
int verifyFile(const std::string &scenarioFile, const std::string &pathFile)
{
    const Scenario scenario = readScenario(scenarioFile);
    const std::vector<Eigen::VectorXd> path = readPathFile(pathFile, scenario);
    const Verdict verdict = verify(scenario.world, path);
    if (verdict.accepted)
    {
        std::cout << fmt::format("accepted: {} waypoints, clearance {:.6g}\n", path.size(), verdict.clearance);
        return ExitDone;
    }
    std::cout << "refused: " << verdict.reason;
    if (verdict.segment >= 0)
        std::cout << fmt::format(", segment {} at {:.6g} of its way", verdict.segment, verdict.fraction);
    if (verdict.link >= 0)
        std::cout << ", link " << verdict.link;
    if (verdict.otherLink >= 0)
        std::cout << ", link " << verdict.otherLink;
    if (!verdict.obstacle.empty())
        std::cout << ", obstacle " << verdict.obstacle;
    if (verdict.tip >= 0)
        std::cout << ", tip " << verdict.tip;
    std::cout << "\n";
    return ExitNot;
}

int recheckDatabase(const std::string &database, double step)
{
    const RecheckResult result = recheck(ResultStore::open(database), step);
    for (const std::string &line : result.refutations)
        std::cout << line << "\n";
    std::cout << fmt::format("{} accepted and {} refused paths, {} states at steps of at most {:g}: {} refutations\n",
                             result.accepted, result.refused, result.states, step, result.refutations.size());
    return result.refutations.empty() ? ExitDone : ExitNot;
}
}  // namespace

void addVerifyCommand(CLI::App &program, int &exitCode)
{
    struct Options
    {
        std::string scenario;
        std::string path;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command = program.add_subcommand("verify", "Judge a path by the independent continuous verifier");
    command->add_option("scenario", options->scenario, "scenario file")->required();
    command->add_option("path", options->path, "JSON with the waypoints, in the scenario's angles")->required();
    command->callback([options, &exitCode] { exitCode = verifyFile(options->scenario, options->path); });
}

void addRecheckCommand(CLI::App &program, int &exitCode)
{
    struct Options
    {
        std::string database;
        double step = 1e-4;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command =
        program.add_subcommand("recheck", "Look at every stored path again: verifier and dense sampling");
    command->add_option("database", options->database, "what `narrows bench` wrote")->required();
    command->add_option("--step", options->step, "most that a point of the arm moves between samples")
        ->capture_default_str();
    command->callback([options, &exitCode] { exitCode = recheckDatabase(options->database, options->step); });
}
}  // namespace narrows
