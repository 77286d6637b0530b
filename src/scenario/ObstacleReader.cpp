// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ObstacleReader.h"

#include <algorithm>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <fmt/format.h>

#include "scenario/ObstacleNames.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
using CgalPolygon = CGAL::Polygon_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

constexpr std::size_t mostVertices = 10000;
/// Beyond this the powers in a superellipse leave the range of a double, and it is a box anyway.
constexpr double largestExponent = 100.0;
/// Least area of a polygon over the square of its perimeter; below it the vertices are collinear but for rounding.
constexpr double leastFatness = 1e-14;

using Shape = std::variant<Circle, Superellipse, Polygon>;

std::optional<Shape> readCircle(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "center", "radius"});
    const std::optional<Eigen::Vector2d> center = entry.required("center").point();
    const std::optional<double> radius = entry.required("radius").positive();
    if (!center || !radius)
        return std::nullopt;
    return Circle{*center, *radius};
}

std::optional<Eigen::Vector2d> readHalfExtents(const Field &field)
{
    const std::vector<Field> items = field.items(2, 2);
    if (items.empty())
        return std::nullopt;
    const std::optional<double> a = items[0].positive();
    const std::optional<double> b = items[1].positive();
    if (!a || !b)
        return std::nullopt;
    return Eigen::Vector2d(*a, *b);
}

std::optional<Shape> readSuperellipse(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "center", "half_extents", "exponent"});
    const std::optional<Eigen::Vector2d> center = entry.required("center").point();
    const std::optional<Eigen::Vector2d> halfExtents = readHalfExtents(entry.required("half_extents"));
    const Field field = entry.optional("exponent");
    const std::optional<double> exponent = field.given() ? field.number() : std::optional<double>(4.0);
    if (exponent && !(*exponent >= 2.0 && *exponent <= largestExponent))
        field.fault(fmt::format("must be from 2 to {}, not {}", largestExponent, *exponent));
    else if (center && halfExtents && exponent)
        return Superellipse{*center, *halfExtents, *exponent};
    return std::nullopt;
}

/// The vertices counter-clockwise; nothing (and a fault) unless they bound a simple polygon.
std::optional<Shape> makePolygon(const Field &field, const std::vector<Eigen::Vector2d> &vertices)
{
    CgalPolygon outline;
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
        outline.push_back({vertices[i].x(), vertices[i].y()});
    }
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

std::optional<Shape> readPolygon(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "vertices"});
    const Field field = entry.required("vertices");
    const std::vector<Field> items = field.items(3, mostVertices);
    std::vector<Eigen::Vector2d> vertices;
    for (const Field &item : items)
        if (const std::optional<Eigen::Vector2d> vertex = item.point())
            vertices.push_back(*vertex);
    if (items.empty() || vertices.size() != items.size())
        return std::nullopt;
    return makePolygon(field, vertices);
}

std::optional<Shape> readBox(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "min", "max"});
    const std::optional<Eigen::Vector2d> low = entry.required("min").point();
    const Field field = entry.required("max");
    const std::optional<Eigen::Vector2d> high = field.point();
    if (!low || !high)
        return std::nullopt;
    if (low->x() < high->x() && low->y() < high->y())
        return makePolygon(entry.field(), {*low, {high->x(), low->y()}, *high, {low->x(), high->y()}});
    field.fault("must be greater than min in both coordinates");
    return std::nullopt;
}

std::optional<Shape> readShape(const Mapping &entry)
{
    const std::string kind = entry.required("kind").oneOf({"circle", "superellipse", "polygon", "box"}).value_or("");
    if (kind == "circle")
        return readCircle(entry);
    if (kind == "superellipse")
        return readSuperellipse(entry);
    if (kind == "polygon")
        return readPolygon(entry);
    if (kind == "box")
        return readBox(entry);
    return std::nullopt;
}
}  // namespace

ObstaclesDraft readObstacles(const Field &field)
{
    ObstaclesDraft draft;
    ObstacleNames names;
    for (const Field &item : field.items(0, mostObstacles))
    {
        const Mapping entry(item);
        const std::string name = names.read(entry);
        if (const std::optional<Shape> shape = readShape(entry))
            draft.obstacles.push_back({name, *shape});
    }
    draft.names = names.all();
    return draft;
}
}  // namespace narrows
