// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SegmentDistance.h"

#include <cmath>
#include <limits>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// Twice the signed area of the triangle abc.
double orientation(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Do the segments cross in their interiors? Touching ends have distance 0 anyway.
bool cross(const Vector2d &a, const Vector2d &b, const Vector2d &c, const Vector2d &d)
{
    return orientation(a, b, c) * orientation(a, b, d) < 0.0 && orientation(c, d, a) * orientation(c, d, b) < 0.0;
}
}  // namespace

double distance(const Vector2d &a, const Vector2d &b, const Vector2d &c, const Vector2d &d)
{
    if (cross(a, b, c, d))
        return 0.0;
    return std::sqrt(std::min(std::min(squaredDistance(a, b, c), squaredDistance(a, b, d)),
                              std::min(squaredDistance(c, d, a), squaredDistance(c, d, b))));
}

bool contains(const Polygon &polygon, const Vector2d &point)
{
    bool inside = false;
    const std::vector<Vector2d> &v = polygon.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
        if ((v[i].y() > point.y()) != (v[j].y() > point.y()) &&
            point.x() < v[i].x() + (point.y() - v[i].y()) * (v[j].x() - v[i].x()) / (v[j].y() - v[i].y()))
            inside = !inside;
    return inside;
}

double distance(const Vector2d &a, const Vector2d &b, const Polygon &polygon)
{
    if (contains(polygon, a))
        return 0.0;
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<Vector2d> &v = polygon.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
        nearest = std::min(nearest, distance(a, b, v[j], v[i]));
    return nearest;
}
}  // namespace narrows
