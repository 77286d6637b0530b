// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

namespace narrows::proof
{
/// Up to Dim points, and the point of their hull that is nearest to the origin: what the search for a separating line
/// or plane remembers.
template <int Dim>
class Simplex;

template <>
class Simplex<2>
{
public:
    using Point = Eigen::Vector2d;

    explicit Simplex(const Point &only) : first_(only), nearest_(only) {}

    const Point &nearest() const { return nearest_; }

    /// Unit vector from the origin to `nearest`. Across a segment it is the normal: near contact `nearest` is a
    /// difference of almost equal numbers, the normal is not.
    Point direction() const
    {
        if (!second_)
            return nearest_.normalized();
        const Point along = *second_ - first_;
        const Point normal = Point(-along.y(), along.x()).normalized();
        return normal.dot(first_) >= 0.0 ? normal : Point(-normal);
    }

    /// Becomes the best simplex within the old one and a new point. False if they enclose the origin.
    bool extend(const Point &added)
    {
        const Simplex one(first_, added);
        if (!second_)
        {
            *this = one;
            return true;
        }
        if (originInTriangle(first_, *second_, added))
            return false;
        const Simplex other(*second_, added);
        *this = one.nearest_.squaredNorm() <= other.nearest_.squaredNorm() ? one : other;
        return true;
    }

private:
    Simplex(const Point &a, const Point &b)
    {
        const Point along = b - a;
        const double squared = along.squaredNorm();
        const double t = squared > 0.0 ? -a.dot(along) / squared : 0.0;
        first_ = t >= 1.0 ? b : a;
        if (t > 0.0 && t < 1.0)
            second_ = b;
        nearest_ = second_ ? Point(a + t * along) : first_;
    }

    static double cross(const Point &a, const Point &b) { return a.x() * b.y() - a.y() * b.x(); }

    static bool originInTriangle(const Point &a, const Point &b, const Point &c)
    {
        const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
        return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
    }

    Point first_;
    std::optional<Point> second_;
    Point nearest_;
};

template <>
class Simplex<3>
{
public:
    using Point = Eigen::Vector3d;

    explicit Simplex(const Point &only) : points_{only}, count_(1), nearest_(only) {}

    const Point &nearest() const { return nearest_; }

    /// As in the plane: at right angles to the simplex, also where `nearest` is made of rounding errors.
    Point direction() const;

    /// Becomes the best simplex within the old one and a new point. False if they enclose the origin.
    bool extend(const Point &added);

private:
    bool encloseOrigin(const Point &added) const;
    void offerSegment(const Point &a, const Point &b);
    void offerTriangle(const Point &a, const Point &b, const Point &c);

    std::array<Point, 3> points_;
    int count_;
    Point nearest_;
};
}  // namespace narrows::proof
