// SPDX-License-Identifier: BSD-3-Clause
// narrows report: a campaign as a page to look at.
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "benchmark/Commands.h"
#include "benchmark/Drawing.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
struct ReportOptions
{
    std::string database;
    std::string folder;
    int slices = 12;
    double megabytes = 8.0;
    bool paper = false;
    bool omplLog = false;
};

int report(const ReportOptions &options)
{
    ResultStore::open(options.database);  // says what is wrong with a file before Python meets it
    // Slices are traced again, by this very program.
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    std::vector<std::string> words{options.database,
                                   "-o",
                                   options.folder,
                                   "--program",
                                   program,
                                   "--slices",
                                   std::to_string(options.slices),
                                   "--motion-megabytes",
                                   std::to_string(options.megabytes)};
    if (options.paper)
        words.push_back("--paper");
    if (options.omplLog)
        words.push_back("--ompl-log");
    runReport(words);
    return ExitDone;
}
}  // namespace

void addReportCommand(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<ReportOptions>();
    CLI::App *command =
        program.add_subcommand("report", "One page of a campaign: verdict, tables, figures and moving arms");
    command->add_option("database", options->database, "what `narrows bench` wrote")->required();
    command->add_option("-o,--output", options->folder, "folder for index.html, made if it is not there")->required();
    command->add_option("--slices", options->slices, "how many of hppm's slices to trace again and show")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    command->add_option("--motion-megabytes", options->megabytes, "how much of the page may be motions")
        ->check(CLI::Range(0.0, 200.0))
        ->capture_default_str();
    command->add_flag("--paper", options->paper, "also write figures as PDF and tables as LaTeX");
    command->add_flag("--ompl-log", options->omplLog, "also write logs for OMPL's ompl_benchmark_statistics");
    command->callback([options, &exitCode] { exitCode = report(*options); });
}
}  // namespace narrows
