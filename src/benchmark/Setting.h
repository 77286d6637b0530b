// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/Text.h"
#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// Takes the text of a value and puts what it means into a variable, which must live as long. What it returns says what
/// is wrong with the text; empty if nothing is.
using Setting = std::function<std::string(const std::string &)>;

/// One word of letters, digits, _, - and .
Setting word(std::string &target);

/// \param least the smallest number that is allowed, as messages shall say it
Setting number(double &target, const std::string &least);

/// Items separated by commas, none of them twice.
Setting list(std::vector<std::string> &target);

/// See limitsFromText().
Setting motionLimits(std::optional<MotionLimits> &target);

/// A whole number from `least` to `most`.
template <typename Integer>
Setting integer(Integer &target, Integer least, Integer most = std::numeric_limits<Integer>::max())
{
    return [&target, least, most](const std::string &value) -> std::string
    {
        const std::optional<double> result = toNumber(value);
        if (!result || *result < static_cast<double>(least) || *result > static_cast<double>(most) ||
            *result != static_cast<double>(static_cast<Integer>(*result)))
            return "'" + value + "' is not a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most);
        target = static_cast<Integer>(*result);
        return "";
    };
}

/// One of several words, each of which stands for a value.
template <typename Value>
Setting oneOf(Value &target, const std::vector<std::pair<std::string, Value>> &choices)
{
    return [&target, choices](const std::string &value) -> std::string
    {
        std::vector<std::string> names;
        for (const auto &[name, meaning] : choices)
        {
            if (name == value)
            {
                target = meaning;
                return "";
            }
            names.push_back(name);
        }
        return "'" + value + "' is none of " + joined(names, ", ");
    };
}
}  // namespace narrows
