// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Setting.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "benchmark/PathTiming.h"

namespace narrows
{
namespace
{
bool isWord(const std::string &text)
{
    const auto fits = [](char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}
}  // namespace

Setting word(std::string &target)
{
    return [&target](const std::string &value)
    {
        target = value;
        return isWord(value) ? "" : "'" + value + "' is not one word of letters, digits, _, - and .";
    };
}

Setting number(double &target, const std::string &least)
{
    return [&target, least](const std::string &value) -> std::string
    {
        const std::optional<double> result = toNumber(value);
        if (!result || *result < *toNumber(least))
            return "'" + value + "' is not a number >= " + least;
        target = *result;
        return "";
    };
}

Setting list(std::vector<std::string> &target)
{
    return [&target](const std::string &value) -> std::string
    {
        target = split(value, ',');
        std::vector<std::string> sorted = target;
        std::sort(sorted.begin(), sorted.end());
        if (sorted.empty() || sorted.front().empty())
            return "expected a list separated by commas";
        const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
        return twin == sorted.end() ? "" : "names '" + *twin + "' twice";
    };
}

Setting motionLimits(std::optional<MotionLimits> &target)
{
    return [&target](const std::string &value) -> std::string
    {
        try
        {
            target = limitsFromText(value);
            return "";
        }
        catch (const std::invalid_argument &error)
        {
            return error.what();
        }
    };
}
}  // namespace narrows
