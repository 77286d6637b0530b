// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// What the verifier says of a path.
struct Verdict
{
    bool accepted = false;
    std::string reason;     ///< empty if accepted, else one of: empty_path, dimension, not_finite, start, goal, limits,
                            ///< collision, not_certified (closer to an obstacle than can be told apart from touching)
    int segment = -1;       ///< index of the waypoint where the offending segment begins; -1 if it is not about one
    double fraction = 0.0;  ///< where on that segment, in [0, 1]
    int link = -1;          ///< which link, -1 if it is not about one
    std::string obstacle;   ///< which obstacle, empty if it is not about one
    double clearance = 0.0;  ///< if accepted: the least distance of any link to any obstacle over the whole path, never
                             ///< overstated and at most `clearanceTolerance` too small; +infinity without obstacles
};

struct VerifierOptions
{
    double clearanceTolerance = 1e-4;  ///< > 0, a length; relative to nothing. Cost grows as it shrinks
    double startTolerance = 1e-9;      ///< in radians (slide: length); how far the path's first waypoint may be off
    double goalTolerance = 1e-9;       ///< the same for the last waypoint and a goal given as configuration
};

/// Judges a path continuously, without sampling between waypoints, by geometry code of its own: supporting lines of
/// convex pieces, nothing shared with the checkers it judges.
///
/// \param path waypoints in absolute angles (slide first), unwrapped: the motion between neighbours is the straight
/// line between the rows as they stand, so a row may differ from the previous one by more than pi only if the joint
/// turns so far. Start and goal configurations are compared modulo 2 pi for joints without limits.
Verdict verify(const PlanarModel &model, const PlanarTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options = {});
}  // namespace narrows
