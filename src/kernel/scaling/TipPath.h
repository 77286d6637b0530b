// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// Appends points of a tip's way that are at most `step` apart, in the slide frame: from where `tips` ends (which stays
/// as it is; it is not empty) along the corners of a leg to its end, where x is to be `endX`. On the way, x changes in
/// proportion and is drawn back by a semicircle that is `retraction` deep in the middle, which keeps the tip from
/// scratching what it works on (step 4).
/// \param corners of the leg in the section plane; the first is where `tips` ends
void appendLeg(const std::vector<Eigen::Vector2d> &corners, double endX, double step, double retraction,
               std::vector<Eigen::Vector3d> &tips);

/// Step 4, the first problem: where on a desired path (a polyline in the section plane) a tip that is not on it should
/// enter it.
struct PathEntry
{
    std::size_t segment;    ///< the entry is between the points segment and segment + 1
    Eigen::Vector2d point;  ///< of the entry
};

/// "Shortest distance": the point of the path nearest to the tip.
/// \pre the path has a point
PathEntry nearestEntry(const std::vector<Eigen::Vector2d> &path, const Eigen::Vector2d &tip);

/// "To the equidistant point": where the line from the tip through the centre of an obstacle, beyond that, first meets
/// the path; both ways round the obstacle are equally long there, more or less. Nothing if it does not meet it.
std::optional<PathEntry> equidistantEntry(const std::vector<Eigen::Vector2d> &path, const Eigen::Vector2d &tip,
                                          const Eigen::Vector2d &center);

/// "To the nearest equidistant point": the equidistant entry nearest to the tip of all obstacles.
std::optional<PathEntry> nearestEquidistantEntry(const std::vector<Eigen::Vector2d> &path, const Eigen::Vector2d &tip,
                                                 const std::vector<Eigen::Vector2d> &centers);
}  // namespace narrows
