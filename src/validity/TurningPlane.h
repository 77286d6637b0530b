// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "validity/SupportDistance.h"

namespace narrows::proof
{
/// A point on its way, at one moment.
template <int Dim>
struct MovingPoint
{
    Point<Dim> position;
    Point<Dim> velocity;
    double travel;  ///< bound of the speed at any moment
    double bend;    ///< bound of the acceleration
};

/// A segment whose ends move; every point of it moves like a mean of these. The bounds of `to` hold for `from`, too.
template <int Dim>
struct MovingSegment
{
    MovingPoint<Dim> from;
    MovingPoint<Dim> to;

    Segment<Dim> now() const { return {from.position, to.position}; }
};

/// Two links, in a frame that may turn.
template <int Dim>
struct MovingPair
{
    MovingSegment<Dim> first;
    MovingSegment<Dim> second;
};

/// Lines or, in space, planes that keep two things apart for a while: at the time t from now their normal is
/// normal + t * turn.
template <int Dim>
struct TurningPlane
{
    Point<Dim> normal;                     ///< unit
    Point<Dim> turn = Point<Dim>::Zero();  ///< at right angles to it

    /// The turn by which it stays as parallel to a segment as it is. Nothing if the segment stands upright on it.
    std::optional<TurningPlane> following(const MovingSegment<Dim> &segment) const;
};

/// A plane that follows one segment, changed so that it follows a second one, too; an edge at rest is one. Nothing if
/// they are parallel.
std::optional<TurningPlane<3>> followingBoth(const TurningPlane<3> &plane, const MovingSegment<3> &first,
                                             const MovingSegment<3> &second);

/// The edge, at rest, on which a plane that turns for a time in [-half, half] would roll over a core; a point if it
/// would not.
MovingSegment<3> edgeAt(const TurningPlane<3> &plane, const ConvexSet<3> &set, double half);

/// The plane keeps at least this distance between a segment and the core of a set at rest, at all times in
/// [-half, half]. Below 0 if it does not separate them.
template <int Dim>
double keptApart(const TurningPlane<Dim> &plane, const MovingSegment<Dim> &segment, const ConvexSet<Dim> &set,
                 double half);

/// The same for two segments; the normal points towards the first.
template <int Dim>
double keptApart(const TurningPlane<Dim> &plane, const MovingSegment<Dim> &segment, const MovingSegment<Dim> &other,
                 double half);
}  // namespace narrows::proof
