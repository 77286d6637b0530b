// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ConvexPieces.h"

#include <iterator>
#include <list>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

namespace narrows
{
namespace
{
using Traits = CGAL::Partition_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using CgalPolygon = Traits::Polygon_2;

Polygon toPolygon(const CgalPolygon &piece)
{
    Polygon polygon;
    for (const auto &vertex : piece.container())
        polygon.vertices.emplace_back(vertex.x(), vertex.y());
    return polygon;
}
}  // namespace

std::vector<Polygon> convexPieces(const Polygon &polygon)
{
    CgalPolygon outline;
    for (const Eigen::Vector2d &vertex : polygon.vertices)
        outline.push_back(Traits::Point_2(vertex.x(), vertex.y()));
    if (outline.size() < 3 || !outline.is_simple())
        throw std::invalid_argument("a polygon needs at least three vertices and must not cross itself");
    if (outline.is_clockwise_oriented())
        outline.reverse_orientation();
    std::list<CgalPolygon> parts;
    if (outline.is_convex())
        parts.push_back(outline);
    else
        CGAL::approx_convex_partition_2(outline.vertices_begin(), outline.vertices_end(), std::back_inserter(parts));
    std::vector<Polygon> pieces;
    for (const CgalPolygon &part : parts)
        pieces.push_back(toPolygon(part));
    return pieces;
}
}  // namespace narrows
