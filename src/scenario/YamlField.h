// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>
#include <Eigen/Core>

#include "kernel/PlanarModel.h"
#include "scenario/FaultList.h"

namespace narrows
{
/// 1-based line of a node; 0 if it has none.
int lineOf(const YAML::Node &node);

/// The text as it may appear in a message: shortened, and without the control characters a quoted YAML text may hold.
std::string printable(std::string text);

/// What a node holds, for messages: "'2.5'", "a list of 3", "a mapping", "nothing".
std::string describe(const YAML::Node &node);

/// One place of the file: a value, or the lack of one, that knows its dotted key.
///
/// The readers return nothing where the value is not what they ask for and then have recorded why. At a place that is
/// not given they return nothing and record nothing: whoever required it already has.
class Field
{
public:
    /// \param line where faults are said to be; 0 takes the node's own line
    Field(FaultList &faults, YAML::Node node, std::string key, int line = 0);
    /// A place the file does not give; faults about it point to `line`.
    Field(FaultList &faults, std::string key, int line);

    bool given() const { return given_; }
    const std::string &key() const { return key_; }
    int line() const { return line_; }
    const YAML::Node &node() const { return node_; }
    FaultList &faults() const { return *faults_; }
    void fault(const std::string &reason) const { faults_->add(line_, key_, reason); }

    bool isWord(const std::string &word) const;
    std::optional<std::string> text() const;
    std::optional<std::string> oneOf(const std::vector<std::string> &words) const;
    /// Finite and at most 1e9 in size.
    std::optional<double> number() const;
    /// A number of at least 1e-9.
    std::optional<double> positive() const;
    std::optional<int> integer(int lowest, int highest) const;
    /// In radians; "42.5 deg" is converted.
    std::optional<double> angle() const;
    std::optional<bool> flag() const;  ///< true or false
    std::optional<Eigen::Vector2d> point() const;
    std::optional<Eigen::Vector3d> spatialPoint() const;
    /// [lower, upper] with lower < upper, of angles or of plain numbers.
    std::optional<Interval> angleInterval() const;
    std::optional<Interval> interval() const;

    /// The entries of a list of `lowest` to `highest` entries; nothing (and a fault) if it is not one.
    std::vector<Field> items(std::size_t lowest, std::size_t highest) const;

private:
    std::optional<double> read(std::optional<double> (*parse)(std::string_view), const char *what) const;
    template <int Dim>
    std::optional<Eigen::Matrix<double, Dim, 1>> numbers() const;
    std::optional<Interval> ordered(std::optional<double> (Field::*reader)() const) const;

    FaultList *faults_;
    YAML::Node node_;
    std::string key_;
    int line_;
    bool given_;
};
}  // namespace narrows
