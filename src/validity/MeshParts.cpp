// SPDX-License-Identifier: BSD-3-Clause
#include "validity/MeshParts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/constants/constants.hpp>

namespace narrows::proof
{
namespace
{
using Eigen::AlignedBox3d;
using Eigen::Vector3d;

using boost::math::double_constants::pi;

Triangle cornersOf(const Mesh &mesh, const std::array<int, 3> &triangle)
{
    return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

ConvexSet<3> around(const Triangle &triangle)
{
    const Vector3d center = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    double radius = 0.0;
    for (const Vector3d &corner : triangle)
        radius = std::max(radius, (corner - center).norm());
    return {triangle, 0.0, center, radius};
}

/// Solid angle that a triangle fills of the view from the origin, with the sign of its orientation (van Oosterom and
/// Strackee 1983).
double solidAngle(const Vector3d &a, const Vector3d &b, const Vector3d &c)
{
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Halves the triangles at the median of their longest extent until single ones are left.
class TreeBuilder
{
public:
    TreeBuilder(std::vector<Triangle> triangles, int obstacle, Parts<3> &parts)
      : triangles_(std::move(triangles)), obstacle_(obstacle), parts_(parts)
    {
    }

    /// Returns the index of the part that holds them. \param begin, end a range of triangles, not empty
    int build(std::size_t begin, std::size_t end)
    {
        const int index = static_cast<int>(parts_.all.size());
        if (end - begin == 1)
        {
            parts_.all.push_back({around(triangles_[begin]), obstacle_});
            return index;
        }
        AlignedBox3d box, centers;
        for (std::size_t i = begin; i < end; ++i)
        {
            for (const Vector3d &corner : triangles_[i])
                box.extend(corner);
            centers.extend(sumOf(triangles_[i]));
        }
        Eigen::Index axis;
        centers.sizes().maxCoeff(&axis);
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                         [axis](const Triangle &one, const Triangle &other)
                         { return sumOf(one)[axis] < sumOf(other)[axis]; });
        parts_.all.push_back({{box, 0.0, box.center(), 0.5 * box.diagonal().norm()}, obstacle_});
        const int first = build(begin, middle), second = build(middle, end);
        parts_.all[index].firstInBox = first;
        parts_.all[index].secondInBox = second;
        return index;
    }

private:
    static Vector3d sumOf(const Triangle &triangle) { return triangle[0] + triangle[1] + triangle[2]; }

    std::vector<Triangle> triangles_;
    int obstacle_;
    Parts<3> &parts_;
};
}  // namespace

bool isClosed(const Mesh &mesh)
{
    std::vector<std::uint64_t> edges;  // smaller end, larger end, direction
    edges.reserve(3 * mesh.triangles.size());
    for (const std::array<int, 3> &triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i)
        {
            const auto from = static_cast<std::uint64_t>(triangle[i]);
            const auto to = static_cast<std::uint64_t>(triangle[(i + 1) % 3]);
            edges.push_back(std::min(from, to) << 33 | std::max(from, to) << 1 | (from < to ? 1 : 0));
        }
    std::sort(edges.begin(), edges.end());
    int surplus = 0;  // of one direction over the other
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        if (i > 0 && edges[i] >> 1 != edges[i - 1] >> 1 && surplus != 0)
            return false;
        surplus += edges[i] & 1 ? 1 : -1;
    }
    return surplus == 0;
}

double turnsAround(const Mesh &mesh, const Vector3d &point)
{
    AlignedBox3d box;
    for (const Vector3d &vertex : mesh.vertices)
        box.extend(vertex);
    if (!box.contains(point))
        return 0.0;
    double angle = 0.0;
    for (const std::array<int, 3> &triangle : mesh.triangles)
    {
        const Triangle corners = cornersOf(mesh, triangle);
        angle += solidAngle(corners[0] - point, corners[1] - point, corners[2] - point);
    }
    return angle / (4.0 * pi);
}

void addTriangles(const Mesh &mesh, int obstacle, Parts<3> &parts)
{
    if (mesh.triangles.empty())
        return;
    std::vector<Triangle> triangles;
    for (const std::array<int, 3> &triangle : mesh.triangles)
        triangles.push_back(cornersOf(mesh, triangle));
    parts.all.reserve(parts.all.size() + 2 * triangles.size());
    TreeBuilder builder(std::move(triangles), obstacle, parts);
    parts.outermost.push_back(builder.build(0, mesh.triangles.size()));
}
}  // namespace narrows::proof
