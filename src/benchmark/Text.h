// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace narrows
{
/// The text without blanks at its ends.
std::string trimmed(const std::string &text);

/// The parts between the separators, trimmed; none for a blank text.
std::vector<std::string> split(const std::string &text, char separator);

std::string joined(const std::vector<std::string> &parts, const std::string &separator);

/// "name=value" texts as pairs, in their order.
/// \param option that they come from, for messages
/// \throws std::invalid_argument if one of them has no name
std::vector<std::pair<std::string, std::string>> assignments(const std::string &option,
                                                             const std::vector<std::string> &texts);

/// \throws std::invalid_argument if the file cannot be written
void writeFile(const std::string &file, const std::string &text);

/// The finite number that the whole text is; nothing for any other text, whatever the locale.
std::optional<double> toNumber(const std::string &text);
}  // namespace narrows
