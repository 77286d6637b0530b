// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/SpatialModel.h"
#include "scenario/MeshFiles.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// What the file says of the obstacles in space, as far as it could be understood.
struct SpatialObstaclesDraft
{
    std::vector<std::string> names;          ///< of all obstacles listed, sound or not
    std::vector<SpatialObstacle> obstacles;  ///< the sound ones
};

SpatialObstaclesDraft readSpatialObstacles(const Field &field, MeshFiles &files);
}  // namespace narrows
