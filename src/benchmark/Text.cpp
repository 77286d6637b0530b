// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Text.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace narrows
{
std::string trimmed(const std::string &text)
{
    const char *blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(const std::string &text, char separator)
{
    std::vector<std::string> parts;
    if (trimmed(text).empty())
        return parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(trimmed(part));
    if (text.back() == separator)
        parts.emplace_back();
    return parts;
}

std::string joined(const std::vector<std::string> &parts, const std::string &separator)
{
    std::string text;
    for (const std::string &part : parts)
        text += (text.empty() ? "" : separator) + part;
    return text;
}

std::vector<std::pair<std::string, std::string>> assignments(const std::string &option,
                                                             const std::vector<std::string> &texts)
{
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string &text : texts)
    {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            throw std::invalid_argument(option + " " + text + ": expected name=value");
        pairs.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return pairs;
}

void writeFile(const std::string &file, const std::string &text)
{
    std::ofstream stream(file);
    stream << text << std::flush;
    if (!stream)
        throw std::invalid_argument(file + ": cannot be written");
}

std::optional<double> toNumber(const std::string &text)
{
    double value = 0.0;
    const char *end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}
}  // namespace narrows
