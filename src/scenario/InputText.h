// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace narrows
{
/// The contents of an input file.
/// \throws InputError if there is no such file, it is a directory, cannot be read or is larger than 16 MiB.
std::string readInputText(const std::string &path);

/// \param file what messages call the text
/// \throws InputError unless the text is UTF-8 without control characters (other than tabs and line ends) and has
/// something in it.
void checkInputText(const std::string &text, const std::string &file);
}  // namespace narrows
