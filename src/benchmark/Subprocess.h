// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace narrows
{
/// Runs a program to its end, on this program's own streams.
/// \param words the program, looked for on the path, and its arguments
/// \param silent its stderr goes nowhere
/// \return the exit code; 127 if it cannot be started, 1 if it was killed
int runProgram(std::vector<std::string> words, bool silent = false);

struct ProgramOutput
{
    int exitCode = 127;  ///< as of runProgram()
    std::string text;    ///< what it wrote to stdout
};

/// The same, with its stdout as text and its stderr nowhere.
ProgramOutput outputOf(std::vector<std::string> words);
}  // namespace narrows
