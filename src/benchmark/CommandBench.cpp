// SPDX-License-Identifier: BSD-3-Clause
// narrows bench, narrows summary: campaigns and their tables.
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "benchmark/Campaign.h"
#include "benchmark/Commands.h"
#include "benchmark/Cores.h"
#include "benchmark/ResultStore.h"
#include "benchmark/Summary.h"

namespace narrows
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;

extern "C" void onSignal(int)
{
    interrupted = 1;
}

struct BenchOptions
{
    std::string experiment;
    std::string shard = "1/1";
    std::string slot = "1/1";
    CampaignOptions campaign;
};

/// The experiment's database, or a name of its own for one shard of several.
std::string defaultDatabase(const Experiment &experiment, const Shard &shard)
{
    std::filesystem::path path = experiment.databasePath();
    if (shard.count > 1)
        path.replace_extension(fmt::format("{}-of-{}.db", shard.index, shard.count));
    return path.string();
}

std::string summarized(const std::string &database, bool markdown)
{
    const std::vector<SummaryRow> rows = summarize(ResultStore::open(database).runs());
    return markdown ? summaryMarkdown(rows) : summaryText(rows);
}

/// Several campaigns at a time share the machine's cores as the runs of one do.
void keepToSlot(const Shard &slot)
{
    if (slot.count > 1)
        keepTo(sharesOf(usablePhysicalCores(),
                        static_cast<std::size_t>(slot.count))[static_cast<std::size_t>(slot.index) - 1]);
}

int bench(BenchOptions options)
{
    keepToSlot(shardFromText(options.slot));
    const Experiment experiment = readExperiment(options.experiment);
    CampaignOptions &campaign = options.campaign;
    campaign.shard = shardFromText(options.shard);
    if (campaign.database.empty())
        campaign.database = defaultDatabase(experiment, campaign.shard);
    campaign.progress = &std::cerr;
    campaign.terminal = isatty(STDERR_FILENO) != 0;
    campaign.stop = []
    {
        return interrupted != 0;
    };
    if (campaign.engine == "isolated")  // the other cannot be asked to stop, but loses nothing that is stored
    {
        std::signal(SIGINT, onSignal);
        std::signal(SIGTERM, onSignal);
    }

    const CampaignResult result = runCampaign(experiment, campaign);
    std::cout << summarized(campaign.database, false) << std::flush;
    std::cerr << fmt::format("{} of {} runs in {}{}\n", result.existing + result.done, result.planned,
                             campaign.database, result.complete() ? "" : "; interrupted, --resume goes on");
    return result.complete() ? ExitDone : ExitNot;
}
}  // namespace

void addBenchCommand(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<BenchOptions>();
    CLI::App *command = program.add_subcommand("bench", "Run an experiment file and print its table");
    command->add_option("experiment", options->experiment, "experiment file (*.cfg)")->required();
    command->add_option("--db", options->campaign.database, "database to write; default: as the experiment says");
    command->add_option("--jobs", options->campaign.jobs, "runs at a time; default: as the experiment says")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option("--shard", options->shard,
                     "i/n: only the i-th of n parts of the runs; `narrows merge` joins the databases")
        ->capture_default_str();
    command
        ->add_option("--slot", options->slot,
                     "i/n: this is the i-th of n campaigns at a time on this machine; keeps to its share of the cores")
        ->capture_default_str();
    command->add_flag("--resume", options->campaign.resume,
                      "do what an existing database lacks; begin one if there is none");
    command->add_option("--engine", options->campaign.engine, "a process per run, or ompl::tools::Benchmark in process")
        ->check(CLI::IsMember({"isolated", "ompl"}))
        ->capture_default_str();
    command->callback([options, &exitCode] { exitCode = bench(*options); });
}

void addSummaryCommand(CLI::App &program, int &exitCode)
{
    struct Options
    {
        std::string database;
        bool markdown = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command = program.add_subcommand("summary", "Print the table of a database");
    command->add_option("database", options->database, "what `narrows bench` wrote")->required();
    command->add_flag("--markdown", options->markdown, "as Markdown");
    command->callback(
        [options, &exitCode]
        {
            std::cout << summarized(options->database, options->markdown);
            exitCode = ExitDone;
        });
}
}  // namespace narrows
