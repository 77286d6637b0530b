// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/TriangleDistance.h"

#include <cmath>
#include <limits>

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// The prism over a triangle, for segments that meet its face.
class Face
{
public:
    explicit Face(const Triangle &triangle) : triangle_(triangle)
    {
        normal_ = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
        square_ = normal_.squaredNorm();
    }

    /// No face, if the triangle is degenerate.
    bool exists() const { return square_ > 0.0; }
    /// Height times the normal's length.
    double height(const Vector3d &point) const { return normal_.dot(point - triangle_[0]); }
    const Vector3d &normal() const { return normal_; }

    /// Whether a point is above the triangle, or so close to that that rounding could hide it.
    bool isUnder(const Vector3d &point) const
    {
        for (int i = 0; i < 3; ++i)
        {
            const Vector3d edge = triangle_[(i + 1) % 3] - triangle_[i];
            if (normal_.dot(edge.cross(point - triangle_[i])) < -1e-12 * square_)
                return false;
        }
        return true;
    }

private:
    const Triangle &triangle_;
    Vector3d normal_;
    double square_;
};

Nearness pierced(const Vector3d &a, const Vector3d &b, double fraction, const Vector3d &faceNormal)
{
    const Vector3d crossing = a + fraction * (b - a);
    const double end = fraction < 0.5 ? 0.0 : 1.0;
    const Vector3d point = end == 0.0 ? a : b;
    const double depth = (crossing - point).norm();
    return {-depth, end, point, depth > 0.0 ? Vector3d((crossing - point) / depth) : faceNormal};
}

/// Where the segment is nearest to an edge.
Nearness besideEdges(const Vector3d &a, const Vector3d &b, const Triangle &triangle, unsigned edges)
{
    double least = std::numeric_limits<double>::infinity();
    double fraction = 0.0;
    Vector3d apart = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
    {
        if ((edges >> i & 1u) == 0)
            continue;
        const Vector3d &c = triangle[i], &d = triangle[(i + 1) % 3];
        const ClosestFractions closest = closestFractions(a, b, c, d);
        const Vector3d way = a + closest.first * (b - a) - c - closest.second * (d - c);
        if (way.squaredNorm() >= least)
            continue;
        least = way.squaredNorm();
        fraction = closest.first;
        apart = way;
    }
    const double distance = std::sqrt(least);
    return {distance, fraction, a + fraction * (b - a),
            distance > 0.0 ? Vector3d(apart / distance) : perpendicular(b - a)};
}
}  // namespace

Nearness nearness(const Vector3d &a, const Vector3d &b, const Triangle &triangle, unsigned edges)
{
    const Face face(triangle);
    if (!face.exists())
        return besideEdges(a, b, triangle, edges);
    const double from = face.height(a), to = face.height(b);
    if (from <= 0.0 ? to >= 0.0 : to <= 0.0)
    {
        const double fraction = from == to ? 0.0 : from / (from - to);
        if (face.isUnder(a + fraction * (b - a)))
            return pierced(a, b, fraction, face.normal().normalized());
        return besideEdges(a, b, triangle, edges);
    }
    // On one side of the plane no point of the segment can be nearer than the lower end, if that is above the face.
    const bool first = std::abs(from) < std::abs(to);
    const Vector3d &end = first ? a : b;
    if (!face.isUnder(end))
        return besideEdges(a, b, triangle, edges);
    const double length = face.normal().norm(), height = first ? from : to;
    return {std::abs(height) / length, first ? 0.0 : 1.0, end, std::copysign(1.0 / length, height) * face.normal()};
}
}  // namespace narrows
