// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A disc.
struct Circle
{
    Eigen::Vector2d center;  ///< its middle
    double radius;           ///< > 0
};

/// |(x - cx) / a|^p + |(y - cy) / b|^p <= 1 (HPPM-PRA, Eq. 22, in the reading of docs/hppm.md). Convex.
struct Superellipse
{
    Eigen::Vector2d center;       ///< its middle
    Eigen::Vector2d halfExtents;  ///< (a, b), both > 0
    double exponent;              ///< p >= 2; 2 is an ellipse, 4 is what the paper uses
};

/// A simple polygon, convex or not, counter-clockwise. Boxes are polygons with four vertices.
struct Polygon
{
    std::vector<Eigen::Vector2d> vertices;  ///< at least 3
};

/// A closed set that no link may touch.
struct PlanarObstacle
{
    std::string name;                                   ///< unique in its scene
    std::variant<Circle, Superellipse, Polygon> shape;  ///< what it occupies
};

/// Axis-parallel box around a shape.
struct Bounds
{
    Eigen::Vector2d lower;  ///< least coordinates
    Eigen::Vector2d upper;  ///< greatest coordinates

    /// The box around two points and all within `room` of them.
    static Bounds around(const Eigen::Vector2d &one, const Eigen::Vector2d &other, double room = 0.0)
    {
        return {one.cwiseMin(other).array() - room, one.cwiseMax(other).array() + room};
    }

    /// Whether the boxes have a point in common. Without branches: the answer is hard to foresee.
    bool meets(const Bounds &other) const
    {
        return (int(upper.x() >= other.lower.x()) & int(lower.x() <= other.upper.x()) &
                int(upper.y() >= other.lower.y()) & int(lower.y() <= other.upper.y())) != 0;
    }
};

/// The smallest such box.
Bounds bounds(const PlanarObstacle &obstacle);
}  // namespace narrows
