// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/PolygonReader.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <fmt/format.h>

namespace narrows
{
namespace
{
using CgalPolygon = CGAL::Polygon_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

/// Least area of a polygon over the square of its perimeter; below it the vertices are collinear but for rounding.
constexpr double leastFatness = 1e-14;

CgalPolygon outlineOf(const std::vector<Eigen::Vector2d> &vertices)
{
    CgalPolygon outline;
    for (const Eigen::Vector2d &vertex : vertices)
        outline.push_back({vertex.x(), vertex.y()});
    return outline;
}
}  // namespace

std::optional<Polygon> makePolygon(const Field &field, const std::vector<Eigen::Vector2d> &vertices)
{
    double perimeter = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        const double edge = (vertices[(i + 1) % vertices.size()] - vertices[i]).norm();
        if (edge == 0.0)
        {
            field.fault(
                fmt::format("vertex {} is repeated by the next (the last is joined to the first by itself)", i));
            return std::nullopt;
        }
        perimeter += edge;
    }
    const CgalPolygon outline = outlineOf(vertices);
    if (!outline.is_simple())
    {
        field.fault("the polygon must be simple, but its edges cross or touch each other");
        return std::nullopt;
    }
    if (std::abs(outline.area()) <= leastFatness * perimeter * perimeter)
    {
        field.fault("the polygon has no area");
        return std::nullopt;
    }
    Polygon polygon{vertices};
    if (outline.is_clockwise_oriented())
        std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    return polygon;
}

std::optional<Polygon> readPolygon(const Field &field, std::size_t most)
{
    const std::vector<Field> items = field.items(3, most);
    std::vector<Eigen::Vector2d> vertices;
    for (const Field &item : items)
        if (const std::optional<Eigen::Vector2d> vertex = item.point())
            vertices.push_back(*vertex);
    if (items.empty() || vertices.size() != items.size())
        return std::nullopt;
    return makePolygon(field, vertices);
}

std::optional<Polygon> readConvexPolygon(const Field &field, std::size_t most)
{
    const std::optional<Polygon> polygon = readPolygon(field, most);
    if (!polygon || outlineOf(polygon->vertices).is_convex())
        return polygon;
    field.fault("the polygon must be convex");
    return std::nullopt;
}
}  // namespace narrows
