// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/TriangleDistance.h"

#include <cmath>

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Of what was looked at so far, the pair of points that is closest.
struct Pair
{
    double squaredDistance;
    double fraction;
    Vector3d foot;

    void consider(double square, double at, const Vector3d &there)
    {
        if (square < squaredDistance)
            *this = {square, at, there};
    }
};

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
    double squaredNormal() const { return square_; }
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
}  // namespace

Nearness nearness(const Vector3d &a, const Vector3d &b, const Triangle &triangle)
{
    const Vector3d along = b - a;
    Pair best{std::numeric_limits<double>::infinity(), 0.0, triangle[0]};
    const Face face(triangle);
    if (face.exists())
    {
        const double from = face.height(a), to = face.height(b);
        if ((from <= 0.0) != (to < 0.0) || from * to <= 0.0)
        {
            const double fraction = from == to ? 0.0 : from / (from - to);
            if (face.isUnder(a + fraction * along))
                return pierced(a, b, fraction, face.normal().normalized());
        }
        for (const auto &[end, height, fraction] : {std::make_tuple(a, from, 0.0), std::make_tuple(b, to, 1.0)})
            if (face.isUnder(end))
                best.consider(height * height / face.squaredNormal(), fraction,
                              end - height / face.squaredNormal() * face.normal());
    }
    for (int i = 0; i < 3; ++i)
    {
        const Vector3d &c = triangle[i], &d = triangle[(i + 1) % 3];
        const ClosestFractions closest = closestFractions(a, b, c, d);
        const Vector3d foot = c + closest.second * (d - c);
        best.consider((a + closest.first * along - foot).squaredNorm(), closest.first, foot);
    }
    const Vector3d point = a + best.fraction * along;
    const double distance = std::sqrt(best.squaredDistance);
    Vector3d normal = point - best.foot;
    normal = normal.squaredNorm() > 0.0 ? normal.normalized() : perpendicular(along);
    return {distance, best.fraction, point, normal};
}
}  // namespace narrows
