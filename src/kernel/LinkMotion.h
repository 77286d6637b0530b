// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace narrows
{
/// A link where it stands: all points within `radius` of the segment from `a` to `b`.
template <int Dim>
struct Link
{
    Eigen::Matrix<double, Dim, 1> a;  ///< one end of the segment
    Eigen::Matrix<double, Dim, 1> b;  ///< the other end
    double radius;                    ///< >= 0
};

/// A point in the middle of a stretch of motion, and what bounds it until either end of the stretch. Rates are by the
/// motion's parameter.
template <int Dim>
struct MovingPoint
{
    using Vector = Eigen::Matrix<double, Dim, 1>;  ///< a place or a velocity

    Vector position;  ///< in the middle of the motion
    Vector velocity;  ///< in the middle
    double way;       ///< bound on its speed, all along the stretch
    double bend;      ///< bound on its acceleration, all along the stretch

    /// Upper bound of the distance from where it is, `half` a stretch away.
    double travel(double half) const { return half * std::min(way, velocity.norm() + 0.5 * half * bend); }

    /// Upper bound of the same along a unit vector: to second order, which is far less for a point that glides past.
    double travelAlong(const Vector &direction, double half) const
    {
        return half * std::min(way, std::abs(direction.dot(velocity)) + 0.5 * half * bend);
    }
};

/// A point that stays where it is.
template <int Dim>
MovingPoint<Dim> resting(const Eigen::Matrix<double, Dim, 1> &position)
{
    return {position, Eigen::Matrix<double, Dim, 1>::Zero(), 0.0, 0.0};
}

/// A link in the middle of a stretch of motion, and what bounds it until either end: the material of certificates that
/// hold for the whole stretch, to first order (reach) and to second order (leastAlong,
/// leastApart, leastBeside).
template <int Dim>
struct LinkMotion
{
    using Vector = Eigen::Matrix<double, Dim, 1>;  ///< a place or a velocity

    MovingPoint<Dim> a;  ///< one end of the link's segment; all its points obey the bounds of the end with the greater
    MovingPoint<Dim> b;  ///< the other end
    double radius;       ///< of the link
    /// Bound on the angular speed. In the plane it is constant; in space the angular acceleration is at most turn^2
    /// / 2.
    double turn;
    double half;  ///< half the length of the stretch, in the motion's parameter

    /// Upper bound of how far any point of the link gets from where it is. Points on a segment move no faster than the
    /// faster of its ends.
    double reach() const
    {
        const double speed = std::sqrt(std::max(a.velocity.squaredNorm(), b.velocity.squaredNorm()));
        return half * std::min(std::max(a.way, b.way), speed + 0.5 * half * std::max(a.bend, b.bend));
    }

    /// Lower bound of direction . x over all points x of the segment, all along the stretch: the link keeps to that
    /// side of a line (plane) that rests. `direction` is a unit vector.
    double leastAlong(const Vector &direction) const
    {
        return std::min(direction.dot(a.position) - a.travelAlong(direction, half),
                        direction.dot(b.position) - b.travelAlong(direction, half));
    }

    /// Lower bound of direction . (x - y) over all points x of this segment and y of another's, all along the stretch.
    /// It knows what they move alike, unlike the sum of two leastAlong().
    double leastApart(const LinkMotion &other, const Vector &direction) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const MovingPoint<Dim> *x : {&a, &b})
            for (const MovingPoint<Dim> *y : {&other.a, &other.b})
            {
                const MovingPoint<Dim> apart{x->position - y->position, x->velocity - y->velocity, x->way + y->way,
                                             x->bend + y->bend};
                least = std::min(least, direction.dot(apart.position) - apart.travelAlong(direction, half));
            }
        return least;
    }

    /// Lower bound, all along the stretch, of the distance between a point and the line (plane) through the segment
    /// that turns with the link and has the unit vector `normal`, perpendicular to the segment, as its normal in the
    /// middle. Negative if the point is, or cannot be told not to come, on the other side.
    ///
    /// With d = direction of the link, w = point - m for a point m of the link, y = normal . w, and the normal carried
    /// along without spinning about d (n' = -(n . d') d):  y' = n . w' - (n . d') (d . w)  and, with |d'| <= turn,
    ///   plane: m = a,  y'' = -turn^2 y +- 2 turn d . w' + n . w''        (d' has constant length)
    ///   space: m next to the point,  |y''| <= sqrt(2) turn^2 |w| + 2 turn |w'| + |w''|.
    double leastBeside(const Vector &normal, const MovingPoint<Dim> &point) const
    {
        const Vector along = b.position - a.position;
        const double square = along.squaredNorm();
        if (!(square > 0.0))
            return -std::numeric_limits<double>::infinity();
        Vector apart = point.position - a.position;
        Vector speed = point.velocity - a.velocity;
        double way = a.way, bend = a.bend;
        const double turning = normal.dot(b.velocity - a.velocity);  // length of the link * (normal . d')
        if constexpr (Dim == 3)
        {
            const double foot = std::clamp(along.dot(apart) / square, 0.0, 1.0);
            apart -= foot * along;
            speed -= foot * (b.velocity - a.velocity);
            way = std::max(a.way, b.way);
            bend = std::max(a.bend, b.bend);
        }
        const double slope = std::abs(normal.dot(speed) - turning * along.dot(apart) / square);
        const double bends = bend + point.bend;
        const double rate = std::min(way + point.way, speed.norm() + half * bends);
        const double now = normal.dot(apart);
        double curvature = 2.0 * turn * rate + bends;
        if constexpr (Dim == 3)
            curvature += std::sqrt(2.0) * turn * turn * (apart.norm() + half * rate);
        else  // While y > 0, the term -turn^2 y only bends it down, so that y stays below this.
            curvature += turn * turn * (std::max(now, 0.0) + half * (slope + 0.5 * half * curvature));
        return now - half * (slope + 0.5 * half * curvature);
    }
};
}  // namespace narrows
