// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/ConvexShape.h"

#include <algorithm>
#include <cmath>

#include "kernel/ConvexParts.h"
#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

Vector2d supportOf(const Circle &circle, const Vector2d &direction)
{
    return circle.center + circle.radius * direction.normalized();
}

/// With 1/p + 1/q = 1 and y = (a dx, b dy): the point (a, b) sign(y) (|y| / |y|_q)^(q - 1).
Vector2d supportOf(const Superellipse &shape, const Vector2d &direction)
{
    const double p = shape.exponent;
    const Vector2d stretched = shape.halfExtents.cwiseProduct(direction);
    const Vector2d size = stretched.cwiseAbs() / stretched.cwiseAbs().maxCoeff();
    const auto raise = [p](double value)
    {
        return p == 4.0 ? std::cbrt(value) : std::pow(value, 1.0 / (p - 1.0));
    };
    const Vector2d raised(raise(size.x()), raise(size.y()));
    // |raised|^p = size^q
    const double norm = raised.dot(size);
    const double scale = p == 4.0 ? 1.0 / std::sqrt(std::sqrt(norm)) : std::pow(norm, -1.0 / p);
    return shape.center + Vector2d(std::copysign(scale * raised.x() * shape.halfExtents.x(), direction.x()),
                                   std::copysign(scale * raised.y() * shape.halfExtents.y(), direction.y()));
}

Vector2d supportOf(const Polygon &polygon, const Vector2d &direction)
{
    const auto nearer = [&](const Vector2d &one, const Vector2d &other)
    {
        return one.dot(direction) < other.dot(direction);
    };
    return *std::max_element(polygon.vertices.begin(), polygon.vertices.end(), nearer);
}

bool isInside(const Circle &circle, const Vector2d &point)
{
    return (point - circle.center).squaredNorm() <= circle.radius * circle.radius;
}

bool isInside(const Superellipse &shape, const Vector2d &point)
{
    const Vector2d size = (point - shape.center).cwiseQuotient(shape.halfExtents).cwiseAbs();
    return std::pow(size.x(), shape.exponent) + std::pow(size.y(), shape.exponent) <= 1.0;
}

bool isInside(const Polygon &polygon, const Vector2d &point)
{
    return narrows::contains(polygon, point);
}

/// What two edges that face each other have in common along `along`, or where they come nearest to that.
double commonPlace(const Vector2d &a, const Vector2d &b, const Vector2d &c, const Vector2d &d, const Vector2d &along)
{
    const double lower = std::max(std::min(a.dot(along), b.dot(along)), std::min(c.dot(along), d.dot(along)));
    const double upper = std::min(std::max(a.dot(along), b.dot(along)), std::max(c.dot(along), d.dot(along)));
    return 0.5 * (lower + upper);
}

Vector2d pointOf(const Vector2d &a, const Vector2d &b, const Vector2d &along, double place)
{
    const double length = (b - a).dot(along);
    if (length == 0.0)
        return a;
    return a + std::min(std::max((place - a.dot(along)) / length, 0.0), 1.0) * (b - a);
}
}  // namespace

ConvexShape::ConvexShape(const Circle &circle) : shape_(circle), box_(bounds({"", circle}))
{
}

ConvexShape::ConvexShape(const Superellipse &superellipse) : shape_(superellipse), box_(bounds({"", superellipse}))
{
}

ConvexShape::ConvexShape(const Polygon &polygon) : shape_(polygon), box_(bounds({"", polygon}))
{
}

Vector2d ConvexShape::support(const Vector2d &direction) const
{
    return std::visit([&](const auto &shape) -> Vector2d { return supportOf(shape, direction); }, shape_);
}

bool ConvexShape::contains(const Vector2d &point) const
{
    return std::visit([&](const auto &shape) { return isInside(shape, point); }, shape_);
}

std::vector<ConvexShape> convexShapes(const std::vector<PlanarObstacle> &obstacles)
{
    std::vector<ConvexShape> shapes;
    for (const PlanarObstacle &obstacle : obstacles)
        if (const Polygon *polygon = std::get_if<Polygon>(&obstacle.shape))
            for (const Polygon &part : convexParts(*polygon))
                shapes.emplace_back(part);
        else if (const Circle *circle = std::get_if<Circle>(&obstacle.shape))
            shapes.emplace_back(*circle);
        else
            shapes.emplace_back(std::get<Superellipse>(obstacle.shape));
    return shapes;
}

NearestPoints nearestPoints(const ConvexShape &first, const ConvexShape &second, double enough)
{
    // Every separating direction has less than a right angle to the line between two inner points, and stays on the
    // side of a direction to which the nearest support points are shifted.
    const Vector2d apart =
        0.5 * (second.box().lower + second.box().upper) - 0.5 * (first.box().lower + first.box().upper);
    const double length = apart.norm();
    if (!(length > 0.0))
        return {Vector2d::Zero(), Vector2d::Zero(), Vector2d::UnitX(), 0.0};
    Vector2d direction = apart / length, lower(direction.y(), -direction.x()), upper = -lower;
    Vector2d from, to;
    const auto support = [&](const Vector2d &towards)
    {
        from = first.support(towards);
        to = second.support(-towards);
    };
    constexpr int bisections = 32;  // to 1e-9
    for (int i = 0; i < bisections; ++i)
    {
        support(direction);
        const Vector2d way = to - from;
        const double distance = way.dot(direction), shift = cross(direction, way);
        // In no direction are the shapes farther apart than these two points.
        if (distance >= enough || (way.dot(lower) <= 0.0 && way.dot(upper) <= 0.0 && distance <= 0.0))
            return {from, to, direction, distance};
        if (std::abs(shift) <= 1e-12 * length)
        {
            lower = upper = direction;
            break;
        }
        (shift > 0.0 ? lower : upper) = direction;
        direction = (lower + upper).normalized();
    }
    support(lower);
    const Vector2d from1 = from, to1 = to;
    support(upper);
    const Vector2d along(-direction.y(), direction.x());
    const double place = commonPlace(from1, from, to1, to, along);
    NearestPoints result{pointOf(from1, from, along, place), pointOf(to1, to, along, place), direction, 0.0};
    result.distance = (result.second - result.first).dot(direction);
    return result;
}
}  // namespace narrows
