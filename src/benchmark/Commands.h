// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace narrows
{
/// What the program returns to its caller.
enum ExitCode
{
    ExitDone = 0,   ///< and, for plan and verify, solved and verified
    ExitNot = 1,    ///< ran, but not solved, not verified, refuted or interrupted
    ExitUsage = 2,  ///< bad usage or bad input file
    ExitInternal = 3
};

/// Each adds its commands to the program; a command that runs leaves its exit code in `exitCode`.
void addPlanCommand(CLI::App &program, int &exitCode);
void addVerifyCommand(CLI::App &program, int &exitCode);
void addBenchCommand(CLI::App &program, int &exitCode);
void addSummaryCommand(CLI::App &program, int &exitCode);
void addRecheckCommand(CLI::App &program, int &exitCode);
void addReplayCommand(CLI::App &program, int &exitCode);
void addMergeCommand(CLI::App &program, int &exitCode);
void addDoctorCommand(CLI::App &program, int &exitCode);
void addSubmitCommands(CLI::App &program, int &exitCode);
void addGenerateCommand(CLI::App &program, int &exitCode);
void addReportCommand(CLI::App &program, int &exitCode);
void addListCommands(CLI::App &program, int &exitCode);
}  // namespace narrows
