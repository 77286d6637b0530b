// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/LinkObstacle.h"

#include "kernel/CircleObstacle.h"
#include "kernel/PolygonObstacle.h"
#include "kernel/SuperellipseObstacle.h"

namespace narrows
{
std::unique_ptr<const LinkObstacle> makeLinkObstacle(const PlanarObstacle &obstacle, double linkRadius, double reach)
{
    if (const auto *circle = std::get_if<Circle>(&obstacle.shape))
        return std::make_unique<CircleObstacle>(*circle, linkRadius);
    if (const auto *polygon = std::get_if<Polygon>(&obstacle.shape))
        return std::make_unique<PolygonObstacle>(*polygon, linkRadius, reach);
    return std::make_unique<SuperellipseObstacle>(std::get<Superellipse>(obstacle.shape), linkRadius, reach);
}
}  // namespace narrows
