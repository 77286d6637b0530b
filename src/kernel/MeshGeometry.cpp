// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/MeshGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr int leafSize = 4;

void checkTriangles(const Mesh &mesh)
{
    if (mesh.triangles.empty())
        throw std::invalid_argument("a mesh needs at least one triangle");
    for (const Vector3d &vertex : mesh.vertices)
        if (!vertex.allFinite())
            throw std::invalid_argument("the vertices of a mesh must be finite");
    for (const std::array<int, 3> &triangle : mesh.triangles)
        for (const int vertex : triangle)
            if (vertex < 0 || vertex >= static_cast<int>(mesh.vertices.size()))
                throw std::invalid_argument("a mesh has no vertex " + std::to_string(vertex));
}

/// Every edge once in each direction: then the surface bounds a volume.
void checkClosed(const Mesh &mesh)
{
    std::set<std::pair<int, int>> edges;
    for (const std::array<int, 3> &triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            if (!edges.emplace(triangle[i], triangle[(i + 1) % 3]).second)
                throw std::invalid_argument("a closed mesh has two triangles on the same side of an edge");
    for (const auto &[from, to] : edges)
        if (edges.count({to, from}) == 0)
            throw std::invalid_argument("a closed mesh has an edge with one triangle only");
}

/// By how much to enlarge a box, so that rounding never leaves out one that is touched.
double roundingOf(const Vector3d &lower, const Vector3d &upper)
{
    return 1e-12 * lower.cwiseAbs().cwiseMax(upper.cwiseAbs()).maxCoeff();
}

/// How often a triangle, seen along z, winds around a point. An edge decides the same for both of its triangles, so
/// that a ray cannot slip between them.
int windingAround(const Vector3d &point, const Triangle &triangle)
{
    int winding = 0;
    for (int i = 0; i < 3; ++i)
    {
        const Vector3d &from = triangle[i], &to = triangle[(i + 1) % 3];
        const bool upward = from.y() <= point.y() && to.y() > point.y();
        const bool downward = to.y() <= point.y() && from.y() > point.y();
        if (!upward && !downward)
            continue;
        const Vector3d low = (upward ? from : to) - point, high = (upward ? to : from) - point;
        if (low.x() * high.y() - high.x() * low.y() > 0.0)
            winding += upward ? 1 : -1;
    }
    return winding;
}

/// Is the triangle above the point, where the vertical line through that meets it?
bool isAbove(const Vector3d &point, const Triangle &triangle)
{
    const Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    return normal.dot(triangle[0] - point) * normal.z() > 0.0;
}
}  // namespace

MeshGeometry::MeshGeometry(const Mesh &mesh) : closed_(mesh.closed)
{
    checkTriangles(mesh);
    if (mesh.closed)
        checkClosed(mesh);
    faces_.reserve(mesh.triangles.size());
    std::set<std::pair<int, int>> taken;
    for (const std::array<int, 3> &triangle : mesh.triangles)
    {
        unsigned edges = 0;
        for (int i = 0; i < 3; ++i)
            if (taken.insert(std::minmax(triangle[i], triangle[(i + 1) % 3])).second)
                edges |= 1u << i;
        faces_.emplace_back(
            Triangle{mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]}, edges);
    }
    build(0, static_cast<int>(faces_.size()));
}

MeshGeometry::Face::Face(const Triangle &triangle, unsigned ownEdges) : corners(triangle), edges(ownEdges)
{
    const Vector3d lower = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const Vector3d upper = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    center = 0.5 * (lower + upper);
    radius = 0.0;
    for (const Vector3d &corner : corners)
        radius = std::max(radius, (corner - center).norm());
    radius += roundingOf(lower, upper);
}

int MeshGeometry::build(int begin, int end)
{
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({faces_[begin].center, faces_[begin].center, 0.0, begin, end, -1});
    for (int i = begin; i < end; ++i)
        for (const Vector3d &vertex : faces_[i].corners)
        {
            nodes_[index].lower = nodes_[index].lower.cwiseMin(vertex);
            nodes_[index].upper = nodes_[index].upper.cwiseMax(vertex);
        }
    const double rounding = roundingOf(nodes_[index].lower, nodes_[index].upper);
    nodes_[index].lower.array() -= rounding;
    nodes_[index].upper.array() += rounding;
    nodes_[index].radius = 0.5 * (nodes_[index].upper - nodes_[index].lower).norm();
    if (end - begin <= leafSize)
        return index;
    Eigen::Index axis = 0;
    (nodes_[index].upper - nodes_[index].lower).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(faces_.begin() + begin, faces_.begin() + middle, faces_.begin() + end,
                     [axis](const Face &one, const Face &other) { return one.center[axis] < other.center[axis]; });
    nodes_[index].end = begin;
    build(begin, middle);
    const int second = build(middle, end);
    nodes_[index].second = second;
    return index;
}

MeshGeometry::SegmentView::SegmentView(const Vector3d &a, const Vector3d &b)
  : from_(a), along_(b - a), lower_(a.cwiseMin(b)), upper_(a.cwiseMax(b))
{
    const double square = along_.squaredNorm();
    inverseSquare_ = square > 0.0 ? 1.0 / square : 0.0;
}

/// The gap between the boxes of both, or between the segment and the ball around the box.
double MeshGeometry::SegmentView::leastDistance(const Node &node) const
{
    const double gap = (node.lower - upper_).cwiseMax(lower_ - node.upper).cwiseMax(0.0).squaredNorm();
    return std::max(std::sqrt(gap), std::sqrt(squaredDistance(0.5 * (node.lower + node.upper))) - node.radius);
}

bool MeshGeometry::contains(const Vector3d &point) const
{
    if (!closed_)
        return false;
    const auto isBelow = [&](const Node &node)
    {
        return node.lower.x() <= point.x() && point.x() <= node.upper.x() && node.lower.y() <= point.y() &&
               point.y() <= node.upper.y() && point.z() <= node.upper.z();
    };
    int winding = 0;
    descend([&](const Node &node) { return isBelow(node) ? 0.0 : 1.0; }, 0.5,
            [&](const Face &face)
            {
                const int turns = windingAround(point, face.corners);
                if (turns != 0 && isAbove(point, face.corners))
                    winding += turns;
                return true;
            });
    return winding != 0;
}

Nearness MeshGeometry::nearest(const Vector3d &a, const Vector3d &b, int *guess) const
{
    Nearness best{std::numeric_limits<double>::infinity(), 0.0, a, Vector3d::UnitX()};
    std::size_t index = faces_.size();
    double limit = best.distance;
    const SegmentView segment(a, b);
    const auto visit = [&](const Face &face)
    {
        const std::size_t number = static_cast<std::size_t>(&face - faces_.data());
        if (number == index || segment.isBeyond(face, limit))
            return true;
        const Nearness here = nearness(a, b, face.corners, face.edges);
        // Among equals the first, so that the answer does not depend on the guess.
        if (here.distance < best.distance || (here.distance == best.distance && number < index))
        {
            best = here;
            index = number;
            limit = std::max(best.distance, 0.0);
        }
        return true;
    };
    if (guess != nullptr && *guess >= 0 && *guess < static_cast<int>(faces_.size()))
        visit(faces_[*guess]);
    descend([&](const Node &node) { return segment.leastDistance(node); }, limit, visit);
    if (guess != nullptr)
        *guess = static_cast<int>(index);
    if (best.distance > 0.0 && contains(a))
    {
        best.distance = -best.distance;
        best.normal = -best.normal;
    }
    return best;
}

bool MeshGeometry::keepsAway(const Vector3d &a, const Vector3d &b, double room) const
{
    return visitWithin(a, b, room, [room](const Triangle &, const Nearness &near) { return near.distance > room; }) &&
           !contains(a);
}
}  // namespace narrows
