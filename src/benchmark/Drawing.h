// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace narrows
{
/// Draws a record (JSON of `narrows plan`) in its scenario by analysis/draw.py.
/// \throws std::runtime_error if the script, Python or one of its packages is missing, or the drawing fails
void drawRecord(const std::string &scenarioFile, const std::string &recordJson, const std::string &outputFile);
}  // namespace narrows
