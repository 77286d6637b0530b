// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Squared distance between the segment ab and a point. Inline: it is what most of a planner's time goes into.
inline double squaredDistance(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Eigen::Vector2d &point)
{
    const double alongX = b.x() - a.x();
    const double alongY = b.y() - a.y();
    double x = point.x() - a.x();
    double y = point.y() - a.y();
    const double projection = alongX * x + alongY * y;
    const double square = alongX * alongX + alongY * alongY;
    if (projection > 0.0)
    {
        const double t = std::min(projection / square, 1.0);
        x -= t * alongX;
        y -= t * alongY;
    }
    return x * x + y * y;
}

/// Distance between the segments ab and cd, 0 if they meet.
double distance(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Eigen::Vector2d &c, const Eigen::Vector2d &d);

/// Is the point inside the polygon? Undecided (either answer) on its edges.
bool contains(const Polygon &polygon, const Eigen::Vector2d &point);

/// Distance between the segment ab and the closed polygon, 0 if they meet.
double distance(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Polygon &polygon);
}  // namespace narrows
