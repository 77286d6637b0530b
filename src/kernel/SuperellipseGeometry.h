// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Distances to one superellipse, with what only depends on the shape worked out once.
class SuperellipseGeometry
{
public:
    explicit SuperellipseGeometry(const Superellipse &shape);

    /// |x/a|^p + |y/b|^p - 1 at a point: negative inside, 0 on the boundary, convex.
    double value(const Eigen::Vector2d &point) const;

    /// Derivative of value() at `point` in the given direction.
    double slope(const Eigen::Vector2d &point, const Eigen::Vector2d &direction) const;

    /// max of direction . (p - center) over the shape; `direction` need not be a unit vector.
    double support(const Eigen::Vector2d &direction) const;

    /// Is the segment ab farther than `threshold` >= 0 from the shape? Stops as soon as bounds decide; a distance equal
    /// to the threshold within 1e-12 of the shape's size counts as not farther.
    bool farther(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double threshold) const;

    /// Distance between the segment ab and the shape, 0 if they meet. Never overstated; at most 1e-11 of the shape's
    /// size too small.
    double distance(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const;

private:
    struct Bracket
    {
        double lower;
        double upper;
    };

    double power(double base) const;
    Eigen::Vector2d supportPoint(const Eigen::Vector2d &direction, double &height) const;
    Bracket segmentDistance(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double threshold,
                            double tolerance) const;
    Bracket pointDistance(const Eigen::Vector2d &point, double threshold, double tolerance) const;

    Eigen::Vector2d center_;
    Eigen::Vector2d halfExtents_;
    double exponent_;
    double dual_;  ///< q with 1/p + 1/q = 1
    bool quartic_;
};
}  // namespace narrows
