// SPDX-License-Identifier: BSD-3-Clause
// narrows submit, narrows status: a campaign in shards, on an engine that is there already.
#include <algorithm>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "benchmark/Commands.h"
#include "benchmark/Submission.h"

namespace narrows
{
namespace
{
/// Says how far the shards are, and merges them once there is nothing left to do.
int follow(const Experiment &experiment, bool unlike)
{
    const ShardFolder folder = ShardFolder::open(experiment);
    const std::vector<std::string> queued = slurmStates(folder);
    std::size_t planned = 0;
    std::size_t done = 0;
    bool complete = true;
    for (const ShardState &state : folder.states())
    {
        const std::string &engine = queued[static_cast<std::size_t>(state.index) - 1];
        planned += state.planned;
        done += state.done;
        complete = complete && state.complete();
        if (!state.complete())
            std::cout << fmt::format("shard {}: {} of {} runs{}{}\n", state.index, state.done, state.planned,
                                     engine.empty() ? "" : ", " + engine,
                                     state.trouble.empty() ? "" : "; its database " + state.trouble);
    }
    std::cout << fmt::format("{} of {} runs in {} shards\n", done, planned, folder.count());
    if (!complete)
        return ExitNot;
    const bool merged = folder.merge(unlike);
    std::cout << fmt::format("{} {}\n", merged ? "merged into" : "already merged:", experiment.databasePath());
    return ExitDone;
}

int submitCampaign(const std::string &file, const SubmissionOptions &options)
{
    const Experiment experiment = readExperiment(file);
    const SubmissionResult result = submit(experiment, options);
    if (result.job.empty())
        return follow(experiment, options.unlike);
    std::cout << fmt::format("submitted {} shards as job {}; `narrows status {}` follows it\n", result.submitted,
                             result.job, file);
    return ExitDone;
}
}  // namespace

void addSubmitCommands(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<SubmissionOptions>();
    const auto file = std::make_shared<std::string>();
    CLI::App *command =
        program.add_subcommand("submit", "Hand a campaign's unfinished shards to Slurm, GNU parallel or this machine");
    command->add_option("experiment", *file, "experiment file (*.cfg)")->required();
    command->add_option("--engine", options->engine, "who runs the shards")
        ->check(CLI::IsMember({"slurm", "parallel", "local"}))
        ->capture_default_str();
    command->add_option("--shards", options->shards, "parts of the campaign")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--jobs", options->jobs, "shards at a time; default: as the engine likes")
        ->check(CLI::Range(1, 100000));
    command->add_option("--minutes", options->minutes, "after which Slurm ends a shard; default: Slurm's")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--sbatch", options->options, "an option for sbatch, such as --partition=long; any number")
        ->allow_extra_args(false);
    command->add_flag("--unlike", options->unlike, "merge even if the shards' environments differ");
    command->callback([options, file, &exitCode] { exitCode = submitCampaign(*file, *options); });

    const auto followed = std::make_shared<std::string>();
    const auto unlike = std::make_shared<bool>(false);
    CLI::App *status =
        program.add_subcommand("status", "Say how far a submitted campaign is; merge it when it is done");
    status->add_option("experiment", *followed, "experiment file (*.cfg)")->required();
    status->add_flag("--unlike", *unlike, "merge even if the shards' environments differ");
    status->callback([followed, unlike, &exitCode] { exitCode = follow(readExperiment(*followed), *unlike); });
}
}  // namespace narrows
