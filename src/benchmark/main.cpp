// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <ompl/util/Console.h>

#include "benchmark/BuildInfo.h"
#include "benchmark/Commands.h"
#include "benchmark/Plugins.h"
#include "scenario/Scenario.h"

namespace
{
/// OMPL's own handler writes to stdout, where results go.
class WarningsOnStderr : public ompl::msg::OutputHandler
{
public:
    void log(const std::string &text, ompl::msg::LogLevel level, const char *, int) override
    {
        if (level >= ompl::msg::LOG_WARN)
            std::cerr << text << std::endl;
    }
};
}  // namespace

int main(int argc, char **argv)
{
    using namespace narrows;
    WarningsOnStderr handler;
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    ompl::msg::useOutputHandler(&handler);

    CLI::App program{"Compares geometric and homotopy planners with sampling planners in narrow places"};
    int exitCode = ExitDone;
    program.require_subcommand(1);
    program.set_version_flag("--version", build::version);
    program.fallthrough();
    program.add_option("--plugin", "shared library with planners (docs/plugins.md); any number")
        ->check(CLI::ExistingFile)
        ->allow_extra_args(false)
        ->take_all()
        ->each(loadPlugin);
    addPlanCommand(program, exitCode);
    addVerifyCommand(program, exitCode);
    addBenchCommand(program, exitCode);
    addSummaryCommand(program, exitCode);
    addRecheckCommand(program, exitCode);
    addReplayCommand(program, exitCode);
    addMergeCommand(program, exitCode);
    addDoctorCommand(program, exitCode);
    addSubmitCommands(program, exitCode);
    addGenerateCommand(program, exitCode);
    addReportCommand(program, exitCode);
    addListCommands(program, exitCode);
    try
    {
        program.parse(argc, argv);
    }
    catch (const CLI::ParseError &error)
    {
        return program.exit(error) == 0 ? ExitDone : ExitUsage;
    }
    catch (const InputError &error)
    {
        for (const InputFault &fault : error.faults())
            std::cerr << fault.text() << "\n";
        exitCode = ExitUsage;
    }
    catch (const std::invalid_argument &error)
    {
        std::cerr << error.what() << "\n";
        exitCode = ExitUsage;
    }
    catch (const std::filesystem::filesystem_error &error)
    {
        std::cerr << error.what() << "\n";
        exitCode = ExitUsage;
    }
    catch (const std::exception &error)
    {
        std::cerr << "internal error: " << error.what() << "\n";
        exitCode = ExitInternal;
    }
    catch (...)
    {
        std::cerr << "internal error: an exception of unknown type\n";
        exitCode = ExitInternal;
    }
    ompl::msg::restorePreviousOutputHandler();
    return exitCode;
}
