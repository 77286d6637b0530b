// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace narrows
{
/// A decimal number as YAML writes it (2, -0.5, 1e-3, .inf, .nan); nothing if the text is anything else.
/// Independent of the locale. A number too large for a double is an infinity.
std::optional<double> parseNumber(std::string_view text);

/// An angle in radians: "0.5", "0.5 rad" or "42.5 deg"; nothing if the text is anything else.
std::optional<double> parseAngle(std::string_view text);
}  // namespace narrows
