// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace narrows
{
/// The text without blanks at its ends.
std::string trimmed(const std::string &text);

/// The parts between the separators, trimmed; none for a blank text.
std::vector<std::string> split(const std::string &text, char separator);

std::string joined(const std::vector<std::string> &parts, const std::string &separator);

/// The finite number that the whole text is; nothing for any other text, whatever the locale.
std::optional<double> toNumber(const std::string &text);
}  // namespace narrows
