// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/MeshSurface.h"

#include <map>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

namespace narrows
{
namespace
{
namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

std::string text(const Eigen::Vector3d &p)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}
}  // namespace

std::string findOpening(const Mesh &mesh)
{
    std::map<std::pair<int, int>, int> trianglesAt;
    for (const std::array<int, 3> &t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++trianglesAt[std::minmax(t[i], t[(i + 1) % 3])];
    for (const auto &[edge, count] : trianglesAt)
        if (count != 2)
            return fmt::format("the edge from {} to {} has {} triangle{}, not 2",
                               text(mesh.vertices[static_cast<std::size_t>(edge.first)]),
                               text(mesh.vertices[static_cast<std::size_t>(edge.second)]), count,
                               count == 1 ? "" : "s");
    return {};
}

std::string orientOutwards(Mesh &mesh)
{
    std::vector<Kernel::Point_3> points;
    for (const Eigen::Vector3d &v : mesh.vertices)
        points.emplace_back(v.x(), v.y(), v.z());
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const std::array<int, 3> &t : mesh.triangles)
        triangles.push_back(
            {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
    if (!pmp::orient_polygon_soup(points, triangles) || points.size() != mesh.vertices.size())
        return "the surface touches itself in a point or has only one side";

    Surface surface;
    pmp::polygon_soup_to_polygon_mesh(points, triangles, surface);
    if (pmp::does_self_intersect(surface))
        return "the surface crosses itself";
    pmp::orient_to_bound_a_volume(surface);
    points.clear();
    triangles.clear();
    pmp::polygon_mesh_to_polygon_soup(surface, points, triangles);
    for (std::size_t i = 0; i < points.size(); ++i)
        mesh.vertices[i] = {points[i].x(), points[i].y(), points[i].z()};
    for (std::size_t i = 0; i < triangles.size(); ++i)
        mesh.triangles[i] = {static_cast<int>(triangles[i][0]), static_cast<int>(triangles[i][1]),
                             static_cast<int>(triangles[i][2])};
    return {};
}
}  // namespace narrows
