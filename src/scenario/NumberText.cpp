// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/NumberText.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace narrows
{
namespace
{
std::string_view withoutSpaceAtEnd(std::string_view text)
{
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

bool dropUnit(std::string_view &text, std::string_view unit)
{
    if (text.size() <= unit.size() || text.substr(text.size() - unit.size()) != unit)
        return false;
    text = withoutSpaceAtEnd(text.substr(0, text.size() - unit.size()));
    return true;
}
}  // namespace

std::optional<double> parseNumber(std::string_view text)
{
    if (!text.empty() && text.front() == '+')
    {
        text.remove_prefix(1);
        if (!text.empty() && text.front() == '-')
            return std::nullopt;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (text == ".inf")
        return infinity;
    if (text == "-.inf")
        return -infinity;
    if (text == ".nan")
        return std::numeric_limits<double>::quiet_NaN();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument)
        return std::nullopt;
    if (error == std::errc::result_out_of_range)  // from_chars does not tell a huge exponent from a tiny one
        return text.find("e-") == std::string_view::npos && text.find("E-") == std::string_view::npos ? infinity : 0.0;
    return value;
}

std::optional<double> parseAngle(std::string_view text)
{
    const bool degrees = dropUnit(text, "deg");
    if (!degrees)
        dropUnit(text, "rad");
    const std::optional<double> value = parseNumber(text);
    if (!value || !degrees)
        return value;
    return *value * M_PI / 180.0;
}
}  // namespace narrows
