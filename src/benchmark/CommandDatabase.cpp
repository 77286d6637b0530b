// SPDX-License-Identifier: BSD-3-Clause
// narrows merge, narrows doctor, narrows replay: what can be done with the databases of campaigns.
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "benchmark/Commands.h"
#include "benchmark/Replay.h"
#include "benchmark/Summary.h"

namespace narrows
{
namespace
{
struct MergeOptions
{
    std::string result;
    std::vector<std::string> parts;
    bool unlike = false;
};

int merge(const MergeOptions &options)
{
    const ResultStore store = ResultStore::merge(options.result, options.parts, options.unlike);
    const std::vector<RunRow> runs = store.runs();
    std::cout << summaryText(summarize(runs));
    std::cerr << fmt::format("{} runs of {} databases in {}\n", runs.size(), options.parts.size(), options.result);
    return ExitDone;
}

int diagnose(const std::string &database)
{
    const Diagnosis diagnosis = ResultStore::open(database).examine();
    for (const std::string &fault : diagnosis.faults)
        std::cout << "fault: " << fault << "\n";
    for (const std::string &note : diagnosis.notes)
        std::cout << "note: " << note << "\n";
    std::cout << database << (diagnosis.faults.empty() ? " is sound\n" : " is not to be trusted\n");
    return diagnosis.faults.empty() ? ExitDone : ExitNot;
}

int replayRun(const std::string &database, std::int64_t id)
{
    const ReplayResult result = replay(ResultStore::open(database), id);
    std::cout << fmt::format("run {}: {} on {}, index {}, seed {}: {}{}\n", id, result.spec.label, result.spec.instance,
                             result.spec.run, result.spec.seed, toString(result.record.outcome),
                             result.record.reason.empty() ? "" : " (" + result.record.reason + ")");
    for (const Deviation &deviation : result.deviations)
        std::cout << fmt::format("  {}: {} stored, {} now\n", deviation.column, deviation.stored, deviation.now);
    if (result.deviations.empty())
        std::cout << "  all that the seed decides is as stored\n";
    else if (result.threaded)
        std::cout << "  the planner has threads of its own: it need not repeat itself\n";
    return result.deviations.empty() ? ExitDone : ExitNot;
}
}  // namespace

void addMergeCommand(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<MergeOptions>();
    CLI::App *command = program.add_subcommand("merge", "Join the databases of a campaign's shards");
    command->add_option("result", options->result, "database to write")->required();
    command->add_option("parts", options->parts, "what `narrows bench --shard` wrote")->required();
    command->add_flag("--unlike", options->unlike, "also if they were measured in environments that differ");
    command->callback([options, &exitCode] { exitCode = merge(*options); });
}

void addDoctorCommand(CLI::App &program, int &exitCode)
{
    const auto database = std::make_shared<std::string>();
    CLI::App *command = program.add_subcommand("doctor", "Look for what is wrong with a database");
    command->add_option("database", *database, "what `narrows bench` wrote")->required();
    command->callback([database, &exitCode] { exitCode = diagnose(*database); });
}

void addReplayCommand(CLI::App &program, int &exitCode)
{
    struct Options
    {
        std::string database;
        std::int64_t run = 0;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command = program.add_subcommand("replay", "Do a stored run once more, alone, and compare");
    command->add_option("database", options->database, "what `narrows bench` wrote")->required();
    command->add_option("run", options->run, "its id in the table `runs`")->required();
    command->callback([options, &exitCode] { exitCode = replayRun(options->database, options->run); });
}
}  // namespace narrows
