// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "validity/SupportDistance.h"

/// For every core shape, its point furthest in a direction.
namespace narrows::proof
{
template <int Dim>
const Point<Dim> &furthestOf(const Segment<Dim> &segment, const Point<Dim> &u)
{
    return segment.from.dot(u) >= segment.to.dot(u) ? segment.from : segment.to;
}

template <class Points, class Point>
const Point &furthestOfAll(const Points &points, const Point &u)
{
    const Point *furthest = &points[0];
    double value = furthest->dot(u);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const double other = points[i].dot(u); other > value)
        {
            value = other;
            furthest = &points[i];
        }
    return *furthest;
}

inline const Eigen::Vector2d &furthestOf(const Hull &hull, const Eigen::Vector2d &u)
{
    return furthestOfAll(hull, u);
}

inline const Eigen::Vector3d &furthestOf(const Triangle &triangle, const Eigen::Vector3d &u)
{
    return furthestOfAll(triangle, u);
}

/// Where the gradient of |x/a|^p + |y/b|^p is parallel to u. Scaled by the larger component first, so that high
/// exponents neither overflow nor vanish.
inline Eigen::Vector2d furthestOf(const Superellipse &shape, const Eigen::Vector2d &u)
{
    const Eigen::Vector2d scaled = shape.halfExtents.cwiseProduct(u);
    const Eigen::Vector2d size = scaled.cwiseAbs();
    const double root = 1.0 / (shape.exponent - 1.0);
    const double ratio = std::pow(size.minCoeff() / size.maxCoeff(), root);
    const double scale = std::pow(1.0 + std::pow(ratio, shape.exponent), -1.0 / shape.exponent);
    const bool wide = size.x() >= size.y();
    const Eigen::Vector2d unit(std::copysign(wide ? scale : ratio * scale, scaled.x()),
                               std::copysign(wide ? ratio * scale : scale, scaled.y()));
    return shape.center + shape.halfExtents.cwiseProduct(unit);
}

inline Eigen::Vector3d furthestOf(const Box &box, const Eigen::Vector3d &u)
{
    const auto turn = box.pose.linear();
    Eigen::Vector3d corner = box.pose.translation();
    for (int axis = 0; axis < 3; ++axis)
        corner += std::copysign(box.halfExtents[axis], turn.col(axis).dot(u)) * turn.col(axis);
    return corner;
}

inline Eigen::Vector3d furthestOf(const Eigen::AlignedBox3d &box, const Eigen::Vector3d &u)
{
    return (u.array() >= 0.0).select(box.max(), box.min());
}

/// On the rim. Where u is nearly along the axis the first difference is made of rounding errors, some of them along the
/// axis, so that it is taken twice; if nothing is left then any point of the end will do.
inline Eigen::Vector3d furthestOf(const Cylinder &cylinder, const Eigen::Vector3d &u)
{
    const auto acrossAxis = [&](const Eigen::Vector3d &vector)
    {
        return Eigen::Vector3d(vector - vector.dot(cylinder.axis) * cylinder.axis);
    };
    const Eigen::Vector3d outwards = acrossAxis(acrossAxis(u).normalized());
    const double size = outwards.norm();
    const Eigen::Vector3d end =
        cylinder.center + std::copysign(cylinder.halfLength, u.dot(cylinder.axis)) * cylinder.axis;
    return size > 0.5 ? Eigen::Vector3d(end + cylinder.radius / size * outwards) : end;
}

inline Eigen::Vector3d furthestOf(const Prism &prism, const Eigen::Vector3d &u)
{
    const Eigen::Vector3d local = prism.pose.linear().transpose() * u;
    const Eigen::Vector2d vertex = furthestOfAll(prism.vertices, Eigen::Vector2d(local.head<2>()));
    return prism.pose * Eigen::Vector3d(vertex.x(), vertex.y(), std::copysign(prism.halfLength, local.z()));
}
}  // namespace narrows::proof
