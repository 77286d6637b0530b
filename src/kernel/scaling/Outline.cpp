// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/Outline.h"

#include <algorithm>

#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
using Eigen::Vector2d;

Vector2d middle(const Outline &outline)
{
    Vector2d sum = Vector2d::Zero();
    for (const Vector2d &corner : outline)
        sum += corner;
    return sum / static_cast<double>(outline.size());
}

double extent(const Outline &outline)
{
    const Vector2d center = middle(outline);
    double most = 0.0;
    for (const Vector2d &corner : outline)
        most = std::max(most, (corner - center).norm());
    return most;
}

double lengthOf(const std::vector<Vector2d> &corners)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        sum += (corners[i] - corners[i - 1]).norm();
    return sum;
}

bool overlap(const Outline &a, const Outline &b)
{
    const Polygon polygon{b};
    for (std::size_t i = 0; i < a.size(); ++i)
        if (distance(a[i], a[following(a, i)], polygon) <= 0.0)
            return true;
    return contains(Polygon{a}, b[0]);
}

std::optional<Stretch> clip(const Vector2d &a, const Vector2d &b, const Outline &outline, double low, double high)
{
    Stretch result{low, high};
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2d edge = outline[following(outline, i)] - outline[i];
        const double height = cross(edge, a - outline[i]);  // >= 0: inside of this edge
        const double slope = cross(edge, b - a);
        if (slope == 0.0 && height < 0.0)
            return std::nullopt;
        if (slope == 0.0)
            continue;
        const double t = -height / slope;
        if (slope > 0.0 && t > result.enters)
        {
            result.enters = t;
            result.entryEdge = i;
        }
        if (slope < 0.0 && t < result.leaves)
        {
            result.leaves = t;
            result.exitEdge = i;
        }
    }
    return result.enters < result.leaves ? std::optional<Stretch>(result) : std::nullopt;
}
}  // namespace narrows
