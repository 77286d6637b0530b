// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scenario/Scenario.h"

namespace narrows
{
/// Draws a record (JSON of `narrows plan`) in its scenario by analysis/draw.py.
/// \param scenarioFile where the scenario was read from
/// \throws std::runtime_error if the script, Python or one of its packages is missing, or the drawing fails
void drawRecord(const Scenario &scenario, const std::string &scenarioFile, const std::string &recordJson,
                const std::string &outputFile);

/// Lets a script of analysis/ draw data that is not a record.
/// \throws std::runtime_error as drawRecord
void drawData(const std::string &script, const std::string &json, const std::string &outputFile);

/// Lets a script of analysis/ report on a database (docs/report.md); it prints what it wrote.
/// \param words what the script is given after its name
/// \throws std::runtime_error if the script, Python or one of its packages is missing, or the script fails
void runReport(const std::vector<std::string> &words);
}  // namespace narrows
