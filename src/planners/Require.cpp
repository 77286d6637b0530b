// SPDX-License-Identifier: BSD-3-Clause
#include "planners/Require.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace narrows
{
namespace
{
template <typename Number>
Number checkRange(Number least, Number value, Number most, const std::string &name)
{
    require(value >= least && value <= most, fmt::format("{} must lie between {} and {}", name, least, most));
    return value;
}
}  // namespace

void require(bool condition, const std::string &message)
{
    if (!condition)
        throw std::invalid_argument(message);
}

int within(int least, int value, int most, const std::string &name)
{
    return checkRange(least, value, most, name);
}

double within(double least, double value, double most, const std::string &name)
{
    return checkRange(least, value, most, name);
}

double notNegative(double value, const std::string &name)
{
    require(value >= 0.0 && std::isfinite(value), name + " must be finite and not negative");
    return value;
}

const std::string &oneOf(std::initializer_list<const char *> words, const std::string &value, const std::string &name)
{
    if (std::find(words.begin(), words.end(), value) == words.end())
        throw std::invalid_argument(fmt::format("{} is one of {}, not \"{}\"", name, fmt::join(words, ", "), value));
    return value;
}
}  // namespace narrows
