// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace narrows
{
/// The names most like `word`, nearest first: those that contain it or are contained in it, and those within two edits
/// (one letter added, dropped or changed), the nearest four at most.
std::vector<std::string> nearNames(const std::string &word, const std::vector<std::string> &names);
}  // namespace narrows
