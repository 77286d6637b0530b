// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "kernel/PlanarObstacle.h"
#include "kernel/SpatialModel.h"

/// The verifier's own geometry: convex sets known by their supporting lines or planes only. Nothing here is shared with
/// the checkers whose answers the verifier judges.
namespace narrows::proof
{
template <int Dim>
using Point = Eigen::Matrix<double, Dim, 1>;

/// All points between two; if these are the same, a point.
template <int Dim>
struct Segment
{
    Point<Dim> from;
    Point<Dim> to;
};

using Hull = std::vector<Eigen::Vector2d>;
using Triangle = std::array<Eigen::Vector3d, 3>;

template <int Dim>
struct CoreShapes;

template <>
struct CoreShapes<2>
{
    using Any = std::variant<Segment<2>, Hull, Superellipse>;
};

template <>
struct CoreShapes<3>
{
    using Any = std::variant<Segment<3>, Triangle, Box, Cylinder, Prism, Eigen::AlignedBox3d>;
};

/// A convex set, given as all points within `inflation` of a core. A ball is an inflated point, a capsule an inflated
/// segment.
template <int Dim>
struct ConvexSet
{
    typename CoreShapes<Dim>::Any core;  ///< cylinders and prisms here have ends
    double inflation = 0.0;
    Point<Dim> center;            ///< of a ball ...
    double boundingRadius = 0.0;  ///< ... that contains the core
};

/// Point of the core furthest in the direction u.
template <int Dim>
Point<Dim> supportPoint(const ConvexSet<Dim> &set, const Point<Dim> &u);

/// The distance between a segment and a core, from both sides.
template <int Dim>
struct Separation
{
    double lower;  ///< how far the line or plane with the normal `direction` separates them: the least u.x on the
                   ///< segment minus the greatest on the core. Negative or zero if none was found that does
    double upper;  ///< >= distance; 0 if they are seen to meet
    Point<Dim> direction;  ///< unit, from the core towards the segment
};

/// When a search for the distance may stop. All gaps are upper - lower.
struct SeparationGoal
{
    double thickness = 0.0;  ///< what counts is the distance minus this; the search ends when upper falls to it
    double enough = std::numeric_limits<double>::infinity();  ///< lower >= enough is enough
    double relativeGap = 0.0;  ///< so is a gap of at most relativeGap * (upper - thickness) ...
    double absoluteGap = std::numeric_limits<double>::infinity();  ///< ... that is no wider than absoluteGap,
    double rounding = 1e-15;  ///< and any gap that cannot be told from rounding errors
};

/// Raises the separation of `segment` and the set's core from the direction `guess` (unit) on, until the goal is
/// reached or rounding ends it: the Gilbert-Johnson-Keerthi iteration. Converges in a few steps for sets with corners;
/// for curved ones, the gap shrinks severalfold a step.
template <int Dim>
Separation<Dim> separate(const ConvexSet<Dim> &set, const Segment<Dim> &segment, const Point<Dim> &guess,
                         const SeparationGoal &goal);

/// The same for two segments.
template <int Dim>
Separation<Dim> separate(const Segment<Dim> &core, const Segment<Dim> &segment, const Point<Dim> &guess,
                         const SeparationGoal &goal);
}  // namespace narrows::proof
