// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/FacingPatch.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double leastCrossing = 0.1;  ///< sine of the angle at which two edges have only a point in common

struct Span
{
    double low, high;

    double half() const { return 0.5 * std::max(0.0, high - low); }
    double middle() const { return 0.5 * (low + high); }
};

Span spanOf(const Points &points, const Vector3d &direction)
{
    Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Vector3d &point : points)
    {
        span.low = std::min(span.low, point.dot(direction));
        span.high = std::max(span.high, point.dot(direction));
    }
    return span;
}

Span common(const Points &first, const Points &second, const Vector3d &direction)
{
    const Span one = spanOf(first, direction), other = spanOf(second, direction);
    return {std::max(one.low, other.low), std::min(one.high, other.high)};
}

bool meetInAPoint(const Points &first, const Points &second)
{
    if (first.size() == 1 || second.size() == 1)
        return true;
    return first.size() == 2 && second.size() == 2 &&
           (first[1] - first[0]).normalized().cross((second[1] - second[0]).normalized()).norm() > leastCrossing;
}
}  // namespace

FacingPatch facingPatch(const Points &first, const Points &second, const Vector3d &axis, const Vector3d &middle)
{
    FacingPatch best{middle, perpendicular(axis), 0.0, 0.0};
    if (meetInAPoint(first, second))
        return best;
    double least = std::numeric_limits<double>::infinity();
    for (const Points *points : {&first, &second})
        for (std::size_t i = 0; i < points->size(); ++i)
            for (std::size_t j = i + 1; j < points->size(); ++j)
            {
                const Vector3d way = (*points)[j] - (*points)[i], flat = way - way.dot(axis) * axis;
                if (!(flat.norm() > 0.5 * way.norm()))
                    continue;
                const Vector3d along = flat.normalized(), aside = axis.cross(along);
                const Span length = common(first, second, along), breadth = common(first, second, aside);
                if (!(length.half() * breadth.half() + 1e-12 * breadth.half() < least))
                    continue;
                least = length.half() * breadth.half() + 1e-12 * breadth.half();
                const bool isLong = length.half() >= breadth.half();
                best = {length.middle() * along + breadth.middle() * aside, isLong ? along : aside,
                        isLong ? length.half() : breadth.half(), isLong ? breadth.half() : length.half()};
            }
    return best;
}
}  // namespace narrows
