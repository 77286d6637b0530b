// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/PlanarObstacle.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// What the file says of the obstacles, as far as it could be understood.
struct ObstaclesDraft
{
    std::vector<std::string> names;         ///< of all obstacles listed, sound or not
    std::vector<PlanarObstacle> obstacles;  ///< the sound ones
};

ObstaclesDraft readObstacles(const Field &field);
}  // namespace narrows
