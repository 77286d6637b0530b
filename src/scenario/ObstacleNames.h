// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "scenario/YamlMapping.h"

namespace narrows
{
constexpr std::size_t mostObstacles = 10000;

/// Reads the names of a list of obstacles, in the order of the list.
class ObstacleNames
{
public:
    /// The entry's name, or "obstacle 3" for the third if it has none. A name that is taken is reported.
    std::string read(const Mapping &entry);
    const std::vector<std::string> &all() const { return names_; }

private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, int> firstLine_;
};
}  // namespace narrows
