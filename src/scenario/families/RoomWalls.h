// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// An axis-parallel box of the plane or of space, lower < upper in every coordinate.
template <int D>
struct AxisBox
{
    using Point = Eigen::Matrix<double, D, 1>;

    Point lower;
    Point upper;

    bool contains(const Point &point) const  ///< strictly inside
    {
        return (point.array() > lower.array()).all() && (point.array() < upper.array()).all();
    }
    double distance(const Point &point) const { return (lower - point).cwiseMax(point - upper).cwiseMax(0.0).norm(); }
    double volume() const { return (upper - lower).prod(); }
};

/// What remains of a solid when rooms are cut out of it, as boxes whose insides do not meet. Their sides lie in planes
/// of the solid's and the rooms' sides; the same input gives the same boxes in the same order.
template <int D>
std::vector<AxisBox<D>> wallsAround(const std::vector<AxisBox<D>> &rooms, const AxisBox<D> &solid);

/// Of a point from the walls, inside of one minus the way out of it.
template <int D>
std::function<double(const Eigen::Matrix<double, D, 1> &)> signedDistance(const std::vector<AxisBox<D>> &walls)
{
    return [walls](const Eigen::Matrix<double, D, 1> &point)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const AxisBox<D> &wall : walls)
        {
            const double inside = (wall.lower - point).cwiseMax(point - wall.upper).maxCoeff();
            least = std::min(least, inside < 0.0 ? inside : wall.distance(point));
        }
        return least;
    };
}

/// The least box around all of them.
/// \pre at least one
inline AxisBox<2> boundsOf(const std::vector<AxisBox<2>> &walls)
{
    AxisBox<2> bounds = walls.front();
    for (const AxisBox<2> &wall : walls)
    {
        bounds.lower = bounds.lower.cwiseMin(wall.lower);
        bounds.upper = bounds.upper.cwiseMax(wall.upper);
    }
    return bounds;
}

extern template std::vector<AxisBox<2>> wallsAround(const std::vector<AxisBox<2>> &, const AxisBox<2> &);
extern template std::vector<AxisBox<3>> wallsAround(const std::vector<AxisBox<3>> &, const AxisBox<3> &);
}  // namespace narrows
