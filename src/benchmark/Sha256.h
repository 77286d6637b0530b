// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace narrows
{
/// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256(const std::string &bytes);
}  // namespace narrows
