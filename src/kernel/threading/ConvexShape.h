// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// A convex obstacle, or a convex part of one, by its support function.
class ConvexShape
{
public:
    /// \pre radius > 0
    explicit ConvexShape(const Circle &circle);
    /// \pre extents > 0, exponent >= 2
    explicit ConvexShape(const Superellipse &superellipse);
    /// \pre the polygon is convex
    explicit ConvexShape(const Polygon &polygon);

    /// A point of the shape that lies furthest in a direction; `direction` need not be a unit vector.
    Eigen::Vector2d support(const Eigen::Vector2d &direction) const;
    /// The border of circles and superellipses is part of it, that of polygons in places.
    bool contains(const Eigen::Vector2d &point) const;
    /// Axis-parallel box around it.
    const Bounds &box() const { return box_; }

private:
    std::variant<Circle, Superellipse, Polygon> shape_;
    Bounds box_;
};

/// One shape per circle and superellipse, one per convex part of a polygon.
std::vector<ConvexShape> convexShapes(const std::vector<PlanarObstacle> &obstacles);

/// Where two convex shapes are nearest to each other.
struct NearestPoints
{
    Eigen::Vector2d first;      ///< point of the first shape
    Eigen::Vector2d second;     ///< of the second
    Eigen::Vector2d direction;  ///< unit vector from the first shape to the second
    double distance;            ///< not positive: the shapes meet, and the points mean nothing
};

/// By bisection of the angle of `direction`, to 1e-9, at which the support lines are furthest apart: exact for
/// polygons, otherwise to the square of that in the distance. Where parallel edges face each other, the points are in
/// the middle of what they have in common. \param enough of shapes that are surely this far apart only that is told: a
/// distance of at least this, no points
NearestPoints nearestPoints(const ConvexShape &first, const ConvexShape &second,
                            double enough = std::numeric_limits<double>::infinity());
}  // namespace narrows
