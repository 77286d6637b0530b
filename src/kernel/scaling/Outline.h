// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// The corners of a convex polygon, counter-clockwise.
using Outline = std::vector<Eigen::Vector2d>;

/// The corner after one.
inline std::size_t following(const Outline &outline, std::size_t corner)
{
    return corner + 1 == outline.size() ? 0 : corner + 1;
}

/// Mean of the corners, a point inside.
Eigen::Vector2d middle(const Outline &outline);

/// Largest distance of a corner from the middle.
double extent(const Outline &outline);

/// Do two outlines have a point in common, insides included?
bool overlap(const Outline &a, const Outline &b);

/// Length of a polyline.
double lengthOf(const std::vector<Eigen::Vector2d> &corners);

/// Where a directed line is inside an outline, as shares of the way from a to b.
struct Stretch
{
    double enters;  ///< share of the way from a to b
    double leaves;  ///< share of the way, > enters
    /// Through which it does.
    std::size_t entryEdge = 0, exitEdge = 0;  ///< edge i goes from corner i to the one following
};

/// The stretch of the line through a and b between two shares of its way; nothing if it misses the outline there.
std::optional<Stretch> clip(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Outline &outline,
                            double low = -std::numeric_limits<double>::infinity(),
                            double high = std::numeric_limits<double>::infinity());
}  // namespace narrows
