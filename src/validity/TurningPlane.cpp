// SPDX-License-Identifier: BSD-3-Clause
#include "validity/TurningPlane.h"

#include <cmath>
#include <limits>

namespace narrows::proof
{
namespace
{
constexpr double upright = 1e-6;  // sine of the angle at which two directions count as parallel

/// How fast u.x grows from one end of a segment to the other: what the turn has to undo.
template <int Dim>
double tilt(const Point<Dim> &normal, const MovingSegment<Dim> &segment)
{
    return (segment.to.velocity - segment.from.velocity).dot(normal);
}

/// How far u.x of a point can fall in the time `half`, u being the plane's normal that turns (before it is scaled back
/// to unit length). `drift` is its derivative now. The second derivative is a.u + 2 v.turn, as u'' = 0.
double fall(double turn, double drift, double travel, double bend, double half)
{
    const double firstOrder = std::abs(drift) * half;
    if (turn == 0.0)
        return std::min(travel * half, firstOrder + 0.5 * bend * half * half);
    return firstOrder + (0.5 * bend * std::hypot(1.0, turn * half) + travel * turn) * half * half;
}

/// What was found for normals of at least unit length and at most hypot(1, turn * half), for unit ones.
double forUnitNormals(double turn, double least, double half)
{
    return turn > 0.0 && least > 0.0 ? least / std::hypot(1.0, turn * half) : least;
}
}  // namespace

template <int Dim>
std::optional<TurningPlane<Dim>> TurningPlane<Dim>::following(const MovingSegment<Dim> &segment) const
{
    const Point<Dim> along = segment.to.position - segment.from.position;
    const Point<Dim> inPlane = along - along.dot(normal) * normal;
    const double squared = inPlane.squaredNorm();
    if (!(squared > upright * upright * along.squaredNorm()))
        return std::nullopt;
    return TurningPlane{normal, -tilt(normal, segment) / squared * inPlane};
}

std::optional<TurningPlane<3>> followingBoth(const TurningPlane<3> &plane, const MovingSegment<3> &first,
                                             const MovingSegment<3> &second)
{
    const Point<3> along = second.to.position - second.from.position;
    const Point<3> across =
        plane.normal.cross(first.to.position - first.from.position);  // may be added: first stays so
    const double lever = across.dot(along);
    if (!(std::abs(lever) > upright * across.norm() * along.norm()))
        return std::nullopt;
    return TurningPlane<3>{plane.normal,
                           plane.turn - (tilt(plane.normal, second) + plane.turn.dot(along)) / lever * across};
}

MovingSegment<3> edgeAt(const TurningPlane<3> &plane, const ConvexSet<3> &set, double half)
{
    const auto restingAt = [&](double t)
    {
        const Point<3> point = supportPoint<3>(set, plane.normal + t * plane.turn);
        return MovingPoint<3>{point, Point<3>::Zero(), 0.0, 0.0};
    };
    return {restingAt(-half), restingAt(half)};
}

/// The core's support function is convex, so that between -half and half it is below its chord.
template <int Dim>
double keptApart(const TurningPlane<Dim> &plane, const MovingSegment<Dim> &segment, const ConvexSet<Dim> &set,
                 double half)
{
    const double turn = plane.turn.norm();
    double chord = 0.0, slope = 0.0;
    if (turn * half == 0.0)
        chord = supportPoint(set, plane.normal).dot(plane.normal);
    else
    {
        const Point<Dim> before = plane.normal - half * plane.turn, after = plane.normal + half * plane.turn;
        const double first = supportPoint(set, before).dot(before), last = supportPoint(set, after).dot(after);
        chord = 0.5 * (first + last);
        slope = 0.5 * (last - first) / half;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const MovingPoint<Dim> *end : {&segment.from, &segment.to})
    {
        const double drift = end->velocity.dot(plane.normal) + end->position.dot(plane.turn) - slope;
        least =
            std::min(least, end->position.dot(plane.normal) - chord - fall(turn, drift, end->travel, end->bend, half));
    }
    return forUnitNormals(turn, least, half);
}

template <int Dim>
double keptApart(const TurningPlane<Dim> &plane, const MovingSegment<Dim> &segment, const MovingSegment<Dim> &other,
                 double half)
{
    const double turn = plane.turn.norm();
    double least = std::numeric_limits<double>::infinity();
    for (const MovingPoint<Dim> *end : {&segment.from, &segment.to})
        for (const MovingPoint<Dim> *second : {&other.from, &other.to})
        {
            const Point<Dim> between = end->position - second->position;
            const double drift = (end->velocity - second->velocity).dot(plane.normal) + between.dot(plane.turn);
            least = std::min(least, between.dot(plane.normal) - fall(turn, drift, end->travel + second->travel,
                                                                     end->bend + second->bend, half));
        }
    return forUnitNormals(turn, least, half);
}

template struct TurningPlane<2>;
template struct TurningPlane<3>;
template double keptApart(const TurningPlane<2> &, const MovingSegment<2> &, const ConvexSet<2> &, double);
template double keptApart(const TurningPlane<3> &, const MovingSegment<3> &, const ConvexSet<3> &, double);
template double keptApart(const TurningPlane<2> &, const MovingSegment<2> &, const MovingSegment<2> &, double);
template double keptApart(const TurningPlane<3> &, const MovingSegment<3> &, const MovingSegment<3> &, double);
}  // namespace narrows::proof
