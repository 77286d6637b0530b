// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scenario/Scenario.h"

namespace narrows
{
/// One `key = value` line of an INI file.
struct IniEntry
{
    std::string section;
    std::string key;
    std::string value;  ///< without comment and surrounding blanks; may be empty
    int line;           ///< 1-based
};

/// Splits text into its entries, in the order of the file. A comment begins with ; or # at the start of a line or after
/// a blank, so that "1, 3; 2, 4" is a value as it stands. Lines that are neither entry, section nor comment become
/// faults.
///
/// Boost.PropertyTree's reader, which OMPL brings along, refuses a key that comes twice (a planner may be listed twice,
/// and the order of the lines then matters) and does not keep line numbers for later messages.
std::vector<IniEntry> parseIni(const std::string &text, const std::string &file, std::vector<InputFault> &faults);
}  // namespace narrows
