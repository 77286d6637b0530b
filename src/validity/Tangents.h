// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SuperellipseGeometry.h"

namespace narrows
{
/// Sixteen tangents of a superellipse: a quick look that settles most links near it.
class Tangents
{
public:
    /// Spread as they would be evenly around a disc that is stretched to the shape, and none along the axes, where
    /// boxes do. They keep off the shape by more than the rounding of what they are compared with.
    explicit Tangents(const Superellipse &shape)
    {
        const SuperellipseGeometry geometry(shape);
        for (int i = 0; i < count; ++i)
        {
            const double angle = (i + 0.5) * 4.0 * std::acos(0.0) / count;
            const Eigen::Vector2d onDisc(std::cos(angle), std::sin(angle));
            const Eigen::Vector2d normal = onDisc.cwiseQuotient(shape.halfExtents).normalized();
            x_[i] = normal.x();
            y_[i] = normal.y();
            offset_[i] = normal.dot(shape.center) + geometry.support(normal) +
                         1e-12 * (shape.halfExtents.sum() + shape.center.norm());
        }
    }

    /// Does one of them certainly keep between the shape and the segment ab, at least `room` away from the segment?
    bool separate(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double room) const
    {
        const Numbers least = (x_ * a.x() + y_ * a.y()).min(x_ * b.x() + y_ * b.y()) - (offset_ + room);
        return least.maxCoeff() > 0.0;
    }

private:
    static constexpr int count = 16;
    using Numbers = Eigen::Array<double, count, 1>;

    Numbers x_, y_, offset_;  ///< x_ p.x + y_ p.y <= offset_ for all points p of the shape
};
}  // namespace narrows
