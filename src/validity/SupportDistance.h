// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarObstacle.h"

/// The verifier's own geometry: convex sets known by their supporting lines only. Nothing here is shared with the
/// checkers whose answers the verifier judges.
namespace narrows
{
/// A convex set, given as all points within `inflation` of a core. A circle is an inflated point.
struct ConvexSet
{
    /// Convex hull of points, or a superellipse.
    std::variant<std::vector<Eigen::Vector2d>, Superellipse> core;
    double inflation = 0.0;
    Eigen::Vector2d center;       ///< of a circle ...
    double boundingRadius = 0.0;  ///< ... that contains the core
};

/// Point of the core furthest in the direction u.
Eigen::Vector2d supportPoint(const ConvexSet &set, const Eigen::Vector2d &u);

/// min(a.u, b.u) - max{x.u : x in the core}: by this much, at least, does the line with the unit normal u separate the
/// segment ab from the core. A lower bound of their distance for every u; the greatest over all u is the distance.
double separationAlong(const ConvexSet &set, const Eigen::Vector2d &a, const Eigen::Vector2d &b,
                       const Eigen::Vector2d &u);

/// The distance between a segment and a core, from both sides.
struct Separation
{
    double lower;               ///< = separationAlong(direction); negative or zero if no separating line was found
    double upper;               ///< >= distance; 0 if they are seen to meet
    Eigen::Vector2d direction;  ///< unit, from the core towards the segment
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

/// Raises the separation from the direction `guess` (unit) on, until the goal is reached or rounding ends it: the
/// Gilbert- Johnson-Keerthi iteration in the plane. Converges in a few steps for hulls; for curves, the gap shrinks
/// fourfold a step.
Separation separate(const ConvexSet &set, const Eigen::Vector2d &a, const Eigen::Vector2d &b,
                    const Eigen::Vector2d &guess, const SeparationGoal &goal);
}  // namespace narrows
