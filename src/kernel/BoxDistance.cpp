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

/// The segment from `from` by `along` and a box around the origin.
class BoxView
{
public:
    BoxView(const Vector3d &from, const Vector3d &along, const Vector3d &half) : from_(from), along_(along), half_(half)
    {
    }

    /// How far outside a point is, per axis, with the sign of its side.
    Vector3d excess(double t) const
    {
        const Vector3d x = from_ + t * along_;
        return x - x.cwiseMax(-half_).cwiseMin(half_);
    }

    /// The squared distance along the segment is convex and consists of parabolas, which meet where the segment crosses
    /// a plane of a face: its slope, linear between such places, is looked at there and at the ends.
    double closest() const
    {
        double low = 0.0, lowSlope = slope(0.0);
        if (lowSlope >= 0.0)
            return 0.0;
        double high = 1.0, highSlope = slope(1.0);
        if (highSlope <= 0.0)
            return 1.0;
        for (int i = 0; i < 3; ++i)
            for (const double side : {-half_[i], half_[i]})
            {
                const double t = (side - from_[i]) / along_[i];
                if (!(t > low && t < high))
                    continue;
                const double there = slope(t);
                (there < 0.0 ? low : high) = t;
                (there < 0.0 ? lowSlope : highSlope) = there;
            }
        return low + (high - low) * (lowSlope / (lowSlope - highSlope));
    }

    /// The axis along which a point of the inside is nearest to the outside.
    Eigen::Index thinnestAxis(double t) const
    {
        Eigen::Index axis = 0;
        const Vector3d depth = half_ - (from_ + t * along_).cwiseAbs();
        depth.minCoeff(&axis);
        return axis;
    }

    double deepest() const
    {
        return convexMinimum(
            [&](double t)
            {
                const Eigen::Index axis = thinnestAxis(t);
                return std::copysign(1.0, from_[axis] + t * along_[axis]) * along_[axis];
            });
    }

private:
    double slope(double t) const { return excess(t).dot(along_); }

    Vector3d from_, along_, half_;
};
}  // namespace

Nearness nearness(const Vector3d &a, const Vector3d &b, const Box &box)
{
    const auto axes = box.pose.linear();
    const Vector3d from = axes.transpose() * (a - box.pose.translation());
    const Vector3d along = axes.transpose() * (b - a);
    const BoxView view(from, along, box.halfExtents);
    const double t = view.closest();
    const Vector3d excess = view.excess(t);
    const double distance = excess.norm();
    if (distance > 1e-9 * box.halfExtents.maxCoeff())
        return {distance, t, a + t * (b - a), axes * (excess / distance)};
    // Where the segment passes through, rounding may have stopped the search just outside.
    const double deepest = view.deepest();
    const Eigen::Index axis = view.thinnestAxis(deepest);
    const double x = from[axis] + deepest * along[axis];
    const double above = std::abs(x) - box.halfExtents[axis];
    if (distance > 0.0 && distance <= above)
        return {distance, t, a + t * (b - a), axes * (excess / distance)};
    return {above, deepest, a + deepest * (b - a), std::copysign(1.0, x) * axes.col(axis)};
}
}  // namespace narrows
