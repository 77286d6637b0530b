// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/YamlField.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenario/NumberText.h"

namespace narrows
{
namespace
{
/// Beyond this a length or an angle is a slip of the pen, and sums of squares lose their meaning.
constexpr double largestNumber = 1e9;
constexpr double smallestLength = 1e-9;
}  // namespace

int lineOf(const YAML::Node &node)
{
    return node.Mark().line + 1;  // yaml-cpp counts from 0 and says -1 where it does not know
}

std::string printable(std::string text)
{
    constexpr std::size_t longest = 60;
    if (text.size() > longest)
        return fmt::format("({} characters)", text.size());
    const auto isControl = [](char c)
    {
        return static_cast<unsigned char>(c) < ' ' || c == 0x7f;
    };
    std::replace_if(text.begin(), text.end(), isControl, '?');
    return text;
}

std::string describe(const YAML::Node &node)
{
    if (node.IsMap())
        return "a mapping";
    if (node.IsSequence())
        return fmt::format("a list of {}", node.size());
    return node.IsScalar() ? fmt::format("'{}'", printable(node.Scalar())) : "nothing";
}

Field::Field(FaultList &faults, YAML::Node node, std::string key, int line)
  : faults_(&faults), node_(std::move(node)), key_(std::move(key)), line_(line > 0 ? line : lineOf(node_)), given_(true)
{
}

Field::Field(FaultList &faults, std::string key, int line)
  : faults_(&faults), key_(std::move(key)), line_(line), given_(false)
{
}

bool Field::isWord(const std::string &word) const
{
    return given_ && node_.IsScalar() && node_.Scalar() == word;
}

std::optional<std::string> Field::text() const
{
    if (!given_)
        return std::nullopt;
    if (node_.IsScalar() && !node_.Scalar().empty())
        return node_.Scalar();
    fault(fmt::format("must be a text, not {}", describe(node_)));
    return std::nullopt;
}

std::optional<std::string> Field::oneOf(const std::vector<std::string> &words) const
{
    if (!given_)
        return std::nullopt;
    if (node_.IsScalar() && std::find(words.begin(), words.end(), node_.Scalar()) != words.end())
        return node_.Scalar();
    const bool maySlip = node_.IsScalar() && words.size() > 1;
    const std::string hint = maySlip ? suggestion(node_.Scalar(), words) : std::string{};
    fault(fmt::format("must be {}, not {}{}", fmt::join(words, " or "), describe(node_), hint));
    return std::nullopt;
}

/// A value that was read by `parse`, if it is a number that can be calculated with; else the fault is noted.
std::optional<double> Field::read(std::optional<double> (*parse)(std::string_view), const char *what) const
{
    if (!given_)
        return std::nullopt;
    const std::optional<double> value = node_.IsScalar() ? parse(node_.Scalar()) : std::nullopt;
    if (!value)
        fault(fmt::format("must be {}, not {}", what, describe(node_)));
    else if (!std::isfinite(*value))
        fault(fmt::format("must be finite, not {}", describe(node_)));
    else if (std::abs(*value) > largestNumber)
        fault(fmt::format("must be at most {} in size, not {}", largestNumber, describe(node_)));
    else
        return value;
    return std::nullopt;
}

std::optional<double> Field::number() const
{
    return read(parseNumber, "a number");
}

std::optional<double> Field::positive() const
{
    const std::optional<double> value = number();
    if (!value || *value >= smallestLength)
        return value;
    fault(fmt::format("must be positive (at least {}), not {}", smallestLength, describe(node_)));
    return std::nullopt;
}

std::optional<int> Field::integer(int lowest, int highest) const
{
    const std::optional<double> value = number();
    if (!value)
        return std::nullopt;
    if (*value == std::floor(*value) && *value >= lowest && *value <= highest)
        return static_cast<int>(*value);
    fault(fmt::format("must be a whole number from {} to {}, not {}", lowest, highest, describe(node_)));
    return std::nullopt;
}

std::optional<double> Field::angle() const
{
    return read(parseAngle, "an angle (radians, or as in '42.5 deg')");
}

std::optional<bool> Field::flag() const
{
    const std::optional<std::string> word = oneOf({"true", "false"});
    return word ? std::optional(*word == "true") : std::nullopt;
}

template <int Dim>
std::optional<Eigen::Matrix<double, Dim, 1>> Field::numbers() const
{
    const std::vector<Field> entries = items(Dim, Dim);
    Eigen::Matrix<double, Dim, 1> values;
    bool sound = !entries.empty();
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        const std::optional<double> value = entries[i].number();
        sound = sound && value;
        values[static_cast<Eigen::Index>(i)] = value.value_or(0.0);
    }
    return sound ? std::optional(values) : std::nullopt;
}

std::optional<Eigen::Vector2d> Field::point() const
{
    return numbers<2>();
}

std::optional<Eigen::Vector3d> Field::spatialPoint() const
{
    return numbers<3>();
}

std::optional<Interval> Field::ordered(std::optional<double> (Field::*reader)() const) const
{
    const std::vector<Field> ends = items(2, 2);
    if (ends.empty())
        return std::nullopt;
    const std::optional<double> lower = (ends[0].*reader)();
    const std::optional<double> upper = (ends[1].*reader)();
    if (!lower || !upper)
        return std::nullopt;
    if (*lower < *upper)
        return Interval{*lower, *upper};
    fault(fmt::format("the lower end {} must be less than the upper end {}", *lower, *upper));
    return std::nullopt;
}

std::optional<Interval> Field::angleInterval() const
{
    return ordered(&Field::angle);
}

std::optional<Interval> Field::interval() const
{
    return ordered(&Field::number);
}

std::vector<Field> Field::items(std::size_t lowest, std::size_t highest) const
{
    if (!given_)
        return {};
    const std::string wanted = lowest == highest ? fmt::format("{}", lowest) : fmt::format("{} to {}", lowest, highest);
    if (!node_.IsSequence() || node_.size() < lowest || node_.size() > highest)
    {
        fault(fmt::format("must be a list of {} entries, not {}", wanted, describe(node_)));
        return {};
    }
    std::vector<Field> fields;
    fields.reserve(node_.size());
    for (const YAML::Node &item : node_)
        fields.emplace_back(*faults_, item, fmt::format("{}[{}]", key_, fields.size()));
    return fields;
}
}  // namespace narrows
