// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// Distances to one superellipse, with what only depends on the shape worked out once.
class SuperellipseGeometry
{
public:
    /// \param shape exponent > 1, extents > 0
    explicit SuperellipseGeometry(const Superellipse &shape);

    const Eigen::Vector2d &center() const { return center_; }  ///< of the shape

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

    /// Bounds on the distance between a segment and the shape.
    struct Separation
    {
        double lower;               ///< of the distance
        double upper;               ///< of the distance
        Eigen::Vector2d direction;  ///< unit vector from the shape to the segment, along which `lower` holds
    };

    /// Stops as soon as lower > enough, or upper <= little, or what the bounds leave open is below 1/32 of lower -
    /// little.
    Separation separate(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double little, double enough) const;

private:
    /// When to stop refining bounds on a distance.
    struct Purpose
    {
        double little;     ///< an upper bound of at most this will do
        double enough;     ///< a lower bound above this will do
        double tolerance;  ///< bounds this close will do
        double share;      ///< so will bounds this close by lower - little
    };

    double power(double base) const;
    Eigen::Vector2d supportPoint(const Eigen::Vector2d &direction, double &height) const;
    double curvatureRadius(const Eigen::Vector2d &point) const;
    Separation segmentDistance(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Purpose &purpose) const;
    Separation pointDistance(const Eigen::Vector2d &point, const Purpose &purpose) const;
    double tolerance() const { return 1e-12 * halfExtents_.maxCoeff(); }

    Eigen::Vector2d center_;
    Eigen::Vector2d halfExtents_;
    double exponent_;
    double dual_;  ///< q with 1/p + 1/q = 1
    bool quartic_;
};
}  // namespace narrows
