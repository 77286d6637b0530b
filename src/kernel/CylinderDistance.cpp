// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kernel/ConvexMinimum.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// A segment in the coordinates of a cylinder: height along its axis and radial vector, both linear on the segment.
class CylinderView
{
public:
    CylinderView(const Vector3d &a, const Vector3d &b, const Cylinder &cylinder) : cylinder_(cylinder)
    {
        const Vector3d from = a - cylinder.center, along = b - a;
        height_ = cylinder.axis.dot(from);
        climb_ = cylinder.axis.dot(along);
        radial_ = from - height_ * cylinder.axis;
        drift_ = along - climb_ * cylinder.axis;
        driftSquare_ = drift_.squaredNorm();
    }

    double height(double t) const { return height_ + t * climb_; }
    Vector3d radial(double t) const { return radial_ + t * drift_; }

    /// Where the segment is closest to the axis' line.
    double closestToLine() const
    {
        const double projection = -radial_.dot(drift_);
        return projection > 0.0 ? std::min(projection / driftSquare_, 1.0) : 0.0;
    }

    /// Half the derivative of the squared distance from the cylinder, which is convex, and half the second one.
    void slope(double t, double &first, double &second) const
    {
        first = second = 0.0;
        const Vector3d radial = radial_ + t * drift_;
        const double distance = radial.norm();
        if (const double excess = distance - cylinder_.radius; excess > 0.0)
        {
            const double rate = radial.dot(drift_) / distance;
            first += excess * rate;
            second += rate * rate + excess / distance * (driftSquare_ - rate * rate);
        }
        const double z = height(t);
        if (const double excess = std::abs(z) - cylinder_.halfLength; excess > 0.0)
        {
            first += std::copysign(excess, z) * climb_;
            second += climb_ * climb_;
        }
    }

    /// The segment's point closest to the cylinder: Newton's method on the slope, kept between bounds.
    double closest() const
    {
        double first, second;
        slope(0.0, first, second);
        if (first >= 0.0)
            return 0.0;
        double low = 0.0, high = 1.0;
        double t = 1.0;
        for (int i = 0; i < 100; ++i)
        {
            slope(t, first, second);
            (first < 0.0 ? low : high) = t;
            const double step = second > 0.0 ? first / second : 1.0;
            if (first == 0.0 || low == 1.0 || std::abs(step) < 1e-15)
                break;
            const double next = t - step;
            const double before = t;
            t = next > low && next < high ? next : 0.5 * (low + high);
            if (t == before)
                break;
        }
        return t;
    }

    /// Inside, the depth is the distance to the mantle or to the nearer end; the segment's deepest point.
    double deepest() const
    {
        return convexMinimum(
            [&](double t)
            {
                const Vector3d radial = this->radial(t);
                const double z = height(t);
                if (radial.norm() - cylinder_.radius >= std::abs(z) - cylinder_.halfLength)
                    return radial.dot(drift_);
                return std::copysign(1.0, z) * climb_;
            });
    }

private:
    const Cylinder &cylinder_;
    double height_, climb_;
    Vector3d radial_, drift_;
    double driftSquare_;
};

/// Signed distance of a point of the segment from the cylinder.
Nearness fromCylinder(const Vector3d &a, const Vector3d &b, double t, const CylinderView &view,
                      const Cylinder &cylinder)
{
    const Vector3d radial = view.radial(t);
    const double height = view.height(t);
    const double length = radial.norm();
    const Vector3d outward = length > 0.0 ? Vector3d(radial / length) : perpendicular(cylinder.axis);
    const Vector3d upward = std::copysign(1.0, height) * cylinder.axis;
    const double beside = length - cylinder.radius;
    const double above = std::abs(height) - cylinder.halfLength;
    Nearness nearest{0.0, t, a + t * (b - a), outward};
    if (beside > 0.0 && above > 0.0)
    {
        nearest.distance = std::hypot(beside, above);
        nearest.normal = (beside * outward + above * upward) / nearest.distance;
    }
    else if (beside >= above)
        nearest.distance = beside;
    else
    {
        nearest.distance = above;
        nearest.normal = upward;
    }
    return nearest;
}

}  // namespace

Nearness nearness(const Vector3d &a, const Vector3d &b, const Cylinder &cylinder)
{
    const CylinderView view(a, b, cylinder);
    if (std::isinf(cylinder.halfLength))
        return fromCylinder(a, b, view.closestToLine(), view, cylinder);
    const Nearness nearest = fromCylinder(a, b, view.closest(), view, cylinder);
    if (nearest.distance > 1e-9 * cylinder.radius)
        return nearest;
    // Where the segment passes through, rounding may have stopped the search just outside.
    const Nearness inside = fromCylinder(a, b, view.deepest(), view, cylinder);
    return inside.distance < nearest.distance ? inside : nearest;
}

}  // namespace narrows
