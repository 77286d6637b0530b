// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Campaign.h"

#include <chrono>
#include <filesystem>
#include <optional>

#include "benchmark/Canary.h"
#include "benchmark/IsolatedRunner.h"
#include "benchmark/OmplEngine.h"
#include "benchmark/Progress.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Every run in a process of its own, the canary's among them.
void runIsolated(const std::vector<RunSpec> &specs, int canary, int jobs, bool pin, ResultStore &store,
                 const std::function<void(std::size_t, const Record &)> &onRecord, const std::function<bool()> &stop)
{
    const std::vector<std::optional<std::size_t>> turns = withCanaries(specs.size(), static_cast<std::size_t>(canary));
    std::vector<RunSpec> queue;
    for (const std::optional<std::size_t> &turn : turns)
        queue.push_back(turn ? specs[*turn] : canaryRun());
    const auto sortOut = [&](std::size_t index, const Record &record)
    {
        if (turns[index])
            onRecord(*turns[index], record);
        else if (!stop())
            store.addCanary(record);
    };
    runAll(queue, jobs, sortOut, stop, pin);
}
}  // namespace

CampaignResult runCampaign(const Experiment &experiment, const CampaignOptions &options)
{
    if (options.engine == "ompl" && (experiment.stateCheckLimit > 0 || experiment.evaluationLimit > 0))
        throw InputError(
            {{experiment.file, 0, "benchmark",
              "state_check_limit and evaluation_limit are for the isolated engine; OMPL's knows time only"}});
    const std::vector<RunSpec> all = runsOf(options.shard, expand(experiment));
    // A campaign that was killed before it had a database is finished by doing all of it.
    const bool begun =
        options.resume && std::filesystem::exists(options.database) && !ResultStore::isBlank(options.database);
    ResultStore store = begun ? ResultStore::resume(options.database, experiment, options.engine)
                              : ResultStore::create(options.database, experiment, options.engine);
    const std::vector<RunSpec> specs = store.missing(all);
    const int jobs = options.jobs > 0 ? options.jobs : experiment.jobs;

    CampaignResult result;
    result.planned = all.size();
    result.existing = all.size() - specs.size();
    if (specs.empty())
        return result;

    std::optional<Progress> progress;
    if (options.progress != nullptr)
        progress.emplace(specs.size(), *options.progress, options.terminal);
    const auto stop = [&]
    {
        return options.stop && options.stop();
    };
    const auto onRecord = [&](std::size_t index, const Record &record)
    {
        // The signal that asks for the end reaches the runs too; what it makes of them is not their result.
        if (stop())
            return;
        store.add(specs[index], record, experiment.savePaths);
        ++result.done;
        if (progress)
            progress->step(record.outcome == Outcome::Solved);
    };

    const auto begin = std::chrono::steady_clock::now();
    store.beginSession(captureEnvironment(jobs));
    if (options.engine == "ompl")
        runOmplBenchmark(specs, std::filesystem::path(options.database).replace_extension().string() + "_", onRecord);
    else
        runIsolated(specs, experiment.canary, jobs, experiment.pin, store, onRecord, stop);
    store.endSession(secondsSince(begin));
    if (progress)
        progress->finish();
    return result;
}
}  // namespace narrows
