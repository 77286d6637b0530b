// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/Gap.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

double boxDistance(const Bounds &one, const Bounds &other)
{
    return (one.lower - other.upper).cwiseMax(other.lower - one.upper).cwiseMax(0.0).norm();
}

double breadth(const ConvexShape &shape, const Vector2d &along)
{
    return (shape.support(along) - shape.support(-along)).dot(along);
}

std::optional<Gap> gapBetween(const ConvexShape &one, const ConvexShape &other, double linkRadius, double widest)
{
    const double tooWide = 2.0 * (widest + linkRadius);
    if (boxDistance(one.box(), other.box()) >= tooWide)
        return std::nullopt;
    const NearestPoints nearest = nearestPoints(one, other, tooWide);
    const double halfWidth = 0.5 * nearest.distance - linkRadius;
    if (!(halfWidth > 0.0) || halfWidth >= widest)
        return std::nullopt;
    const Vector2d along(-nearest.direction.y(), nearest.direction.x());
    const auto extent = [&](const ConvexShape &shape)
    {
        return std::max(breadth(shape, along), breadth(shape, nearest.direction));
    };
    return Gap{0.5 * (nearest.first + nearest.second), nearest.direction, halfWidth,
               0.5 * std::min(extent(one), extent(other))};
}
}  // namespace

std::vector<Gap> findGaps(const std::vector<PlanarObstacle> &obstacles, double linkRadius, double widest)
{
    if (!(linkRadius >= 0.0) || !(widest > 0.0))
        throw std::invalid_argument("gaps need a link radius of at least 0 and a positive greatest width");
    const std::vector<ConvexShape> shapes = convexShapes(obstacles);
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t j = i + 1; j < shapes.size(); ++j)
        {
            const std::optional<Gap> gap = gapBetween(shapes[i], shapes[j], linkRadius, widest);
            // What a third one fills is no gap: other parts of the same polygon do.
            if (gap && std::none_of(shapes.begin(), shapes.end(),
                                    [&](const ConvexShape &shape) { return shape.contains(gap->middle); }))
                gaps.push_back(*gap);
        }
    return gaps;
}
}  // namespace narrows
