// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TipPath.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/Cross.h"

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

void appendLeg(const std::vector<Vector2d> &corners, double endX, double step, double retraction,
               std::vector<Vector3d> &tips)
{
    double whole = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        whole += (corners[i] - corners[i - 1]).norm();
    const double beginX = tips.back().x();
    const auto depth = [&](double share)
    {
        const double off = 2.0 * share - 1.0;
        return beginX + share * (endX - beginX) - retraction * std::sqrt(std::max(0.0, 1.0 - off * off));
    };
    double done = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i)
    {
        const Vector2d way = corners[i] - corners[i - 1];
        const double length = way.norm();
        const double inX = whole > 0.0 ? std::abs(endX - beginX) * length / whole : std::abs(endX - beginX);
        const int count = std::max(1, static_cast<int>(std::ceil(std::hypot(length, inX) / step)));
        for (int k = 1; k <= count; ++k)
        {
            const double share = static_cast<double>(k) / count;
            const double along = whole > 0.0 ? (done + share * length) / whole : share;
            const Vector2d point = corners[i - 1] + share * way;
            tips.emplace_back(depth(along), point.x(), point.y());
        }
        done += length;
        tips.back().tail<2>() = corners[i];
    }
    tips.back().x() = endX;
}

PathEntry nearestEntry(const std::vector<Vector2d> &path, const Vector2d &tip)
{
    PathEntry best{0, path.front()};
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        const Vector2d way = path[i + 1] - path[i];
        const double square = way.squaredNorm();
        const double t = square > 0.0 ? std::clamp(way.dot(tip - path[i]) / square, 0.0, 1.0) : 0.0;
        const Vector2d point = path[i] + t * way;
        if ((point - tip).squaredNorm() < (best.point - tip).squaredNorm())
            best = {i, point};
    }
    return best;
}

std::optional<PathEntry> equidistantEntry(const std::vector<Vector2d> &path, const Vector2d &tip,
                                          const Vector2d &center)
{
    const Vector2d ray = center - tip;
    std::optional<PathEntry> found;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
        const Vector2d way = path[i + 1] - path[i];
        const double slope = cross(ray, way);
        if (slope == 0.0)
            continue;
        const double onRay = cross(path[i] - tip, way) / slope;
        const double onPath = cross(path[i] - tip, ray) / slope;
        if (onRay >= 1.0 && onRay < nearest && onPath >= 0.0 && onPath <= 1.0)
        {
            nearest = onRay;
            found = PathEntry{i, path[i] + onPath * way};
        }
    }
    return found;
}

std::optional<PathEntry> nearestEquidistantEntry(const std::vector<Vector2d> &path, const Vector2d &tip,
                                                 const std::vector<Vector2d> &centers)
{
    std::optional<PathEntry> best;
    for (const Vector2d &center : centers)
    {
        const std::optional<PathEntry> entry = equidistantEntry(path, tip, center);
        if (entry && (!best || (entry->point - tip).squaredNorm() < (best->point - tip).squaredNorm()))
            best = entry;
    }
    return best;
}
}  // namespace narrows
