// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ConvexParts.h"

#include <algorithm>

namespace narrows
{
using Eigen::Vector2d;

namespace
{
using Corners = std::vector<Vector2d>;

/// Positive if the corner at `i` bends to the left.
double bend(const Corners &corners, std::size_t i)
{
    const std::size_t n = corners.size();
    const Vector2d before = corners[i] - corners[(i + n - 1) % n];
    const Vector2d after = corners[(i + 1) % n] - corners[i];
    return before.x() * after.y() - before.y() * after.x();
}

bool isConvex(const Corners &corners)
{
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (bend(corners, i) < 0.0)
            return false;
    return true;
}

/// Does the closed triangle contain the point?
bool contains(const Corners &triangle, const Vector2d &point)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Vector2d edge = triangle[(i + 1) % 3] - triangle[i];
        const Vector2d to = point - triangle[i];
        if (edge.x() * to.y() - edge.y() * to.x() < 0.0)
            return false;
    }
    return true;
}

/// Can the corner be cut off without cutting through the polygon?
bool isEar(const Corners &corners, std::size_t i)
{
    const std::size_t n = corners.size();
    if (!(bend(corners, i) > 0.0))
        return false;
    const Corners ear{corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]};
    const auto inside = [&ear](const Vector2d &corner)
    {
        return std::find(ear.begin(), ear.end(), corner) == ear.end() && contains(ear, corner);
    };
    return std::none_of(corners.begin(), corners.end(), inside);
}
}  // namespace

std::vector<Polygon> convexParts(const Polygon &polygon)
{
    Corners rest = polygon.vertices;
    std::vector<Polygon> parts;
    while (!isConvex(rest))
    {
        std::size_t i = 0;
        while (i < rest.size() && !isEar(rest, i))
            ++i;
        if (i == rest.size())
            break;  // rounding has hidden the ears: what is left stays one part
        const std::size_t n = rest.size();
        parts.push_back({{rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]}});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    }
    parts.push_back({std::move(rest)});
    return parts;
}
}  // namespace narrows
