// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ObstacleReader.h"

#include <fmt/format.h>

#include "scenario/ObstacleNames.h"
#include "scenario/PolygonReader.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostVertices = 10000;
/// Beyond this the powers in a superellipse leave the range of a double, and it is a box anyway.
constexpr double largestExponent = 100.0;

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

std::optional<Shape> readPolygon(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "vertices"});
    const std::optional<Polygon> polygon = readPolygon(entry.required("vertices"), mostVertices);
    return polygon ? std::optional<Shape>(*polygon) : std::nullopt;
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
