// SPDX-License-Identifier: BSD-3-Clause
#include "validity/LaneObstacles.h"

#include <algorithm>

namespace narrows
{
namespace
{
float single(double x)
{
    return static_cast<float>(x);
}
}  // namespace

lanes::Range laneRange(double contact, double room)
{
    const double far = contact + room, near = contact - room;
    return {single(far * far), near > 0.0 ? single(near * near) : -1.0f, single(room)};
}

LaneObstacles::LaneObstacles(const std::vector<PlanarObstacle> &obstacles, double radius, double room) : radius_(radius)
{
    for (const PlanarObstacle &obstacle : obstacles)
    {
        const Bounds box = bounds(obstacle);
        const double extent = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
        const double own = room + lanes::rounding * 24 * extent, around = radius + own;
        boxes_.push_back({single(box.lower.x() - around), single(box.lower.y() - around),
                          single(box.upper.x() + around), single(box.upper.y() + around)});
        shapes_.push_back(std::visit([&](const auto &shape) { return shapeOf(shape, own); }, obstacle.shape));
    }
}

LaneObstacles::Shape LaneObstacles::shapeOf(const Circle &circle, double room) const
{
    return lanes::Circle{single(circle.center.x()), single(circle.center.y()),
                         laneRange(circle.radius + radius_, room)};
}

LaneObstacles::Shape LaneObstacles::shapeOf(const Superellipse &shape, double room) const
{
    if (shape.exponent != 4.0)
        return Boxed{};
    // A disc of radius `room` has this size at most where the shape's is 1.
    const double inner = 1.0 - room / shape.halfExtents.minCoeff() - 1e-5;
    return lanes::Quartic{single(shape.center.x()),
                          single(shape.center.y()),
                          single(1.0 / shape.halfExtents.x()),
                          single(1.0 / shape.halfExtents.y()),
                          single(radius_ + room),
                          inner > 0.0 ? single(inner * inner * inner * inner) : -1.0f};
}

LaneObstacles::Shape LaneObstacles::shapeOf(const narrows::Polygon &polygon, double room) const
{
    Polygon shape{{}, laneRange(radius_, room)};
    const std::vector<Eigen::Vector2d> &v = polygon.vertices;
    for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
        shape.edges.push_back({single(v[j].x()), single(v[j].y()), single(v[i].x()), single(v[i].y())});
    return shape;
}

void LaneObstacles::examine(std::size_t k, const lanes::Points &a, const lanes::Points &b, lanes::Findings &found) const
{
    const Shape &shape = shapes_[k];
    if (const auto *circle = std::get_if<lanes::Circle>(&shape))
        lanes::examine(a, b, *circle, found);
    else if (const auto *quartic = std::get_if<lanes::Quartic>(&shape))
        lanes::examine(a, b, *quartic, found);
    else if (const auto *polygon = std::get_if<Polygon>(&shape))
        lanes::examine(a, b, polygon->edges.data(), static_cast<int>(polygon->edges.size()), polygon->range, found);
    else
        std::transform(found.of, found.of + lanes::count, found.of, [](std::int32_t one) { return std::max(one, 1); });
}
}  // namespace narrows
