// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scenario/families/ArmScene.h"
#include "scenario/families/ChainScene.h"
#include "scenario/families/PipeScene.h"
#include "scenario/families/SpaceScene.h"

namespace narrows
{
/// One parameter of a family. All values are kept as numbers; a flag is 0 or 1, a name its place in `names`.
struct FamilyParameter
{
    enum class Kind
    {
        Whole,
        Real,
        Flag,
        Name
    };

    std::string name;
    Kind kind;
    std::optional<double> standard;  ///< what it is unless given; nothing if the family decides
    double lowest;
    double highest;
    std::string meaning;
    std::vector<std::string> names = {};  ///< that may be given, in place of lowest and highest

    /// "0 to 1", "true, false" or the names.
    std::string range() const;
    /// What a text says.
    /// \throws std::invalid_argument telling what it must be
    double read(const std::string &text) const;
    /// The value as files write it.
    std::string write(double value) const;
};

/// Values by name: all that have a standard, and those that are given beside.
using FamilyValues = std::map<std::string, double>;

/// What families draw.
using Scene = std::variant<ArmScene, PipeScene, ChainScene<2>, ChainScene<3>, SpaceScene>;

/// The scenario file of a scene.
std::string toYaml(const Scene &scene, const std::string &name, const std::string &source);

/// A kind of scenes with parameters. The same values draw the same scene, on every machine.
struct Family
{
    std::string name;
    std::string summary;
    std::vector<FamilyParameter> parameters;
    /// \throws std::invalid_argument if the values do not fit each other, or if no such scene was found in many draws
    std::function<Scene(const FamilyValues &)> draw;

    /// \throws std::invalid_argument if there is no such parameter
    const FamilyParameter &parameter(const std::string &key) const;
    /// \param given texts by parameter, over the standard values
    /// \throws std::invalid_argument if there is no such parameter or a text is no value of it
    FamilyValues values(const std::map<std::string, std::string> &given) const;
    /// "slab: half_width 0.01, links 3, seed 1"
    std::string describe(const FamilyValues &values) const;
};

/// All there are, by name.
const std::vector<Family> &families();

/// \throws std::invalid_argument if there is none of this name
const Family &findFamily(const std::string &name);
}  // namespace narrows
