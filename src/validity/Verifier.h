// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"

namespace narrows
{
/// What the verifier says of a path.
struct Verdict
{
    bool accepted = false;  ///< whether every condition holds
    std::string reason;     ///< empty if accepted, else one of: empty_path, dimension, not_finite, start, tip_path,
                            ///< goal, limits, collision, self_collision, not_certified (closer than can be told apart
                            ///< from touching)
    int segment = -1;       ///< index of the waypoint where the offending segment begins; -1 if it is not about one
    double fraction = 0.0;  ///< where on that segment, in [0, 1]
    int link = -1;          ///< which link, -1 if it is not about one
    int otherLink = -1;     ///< the link that it meets, -1 if it is not about two links
    std::string obstacle;   ///< which obstacle, empty if it is not about one
    int tip = -1;  ///< which point of the goal's tip path was not reached in its turn; -1 if it is not about one
    double clearance = 0.0;  ///< if accepted: the least distance of any link to any obstacle, or to a link that it must
                             ///< not touch, over the whole path: never overstated and at most `clearanceTolerance` too
                             ///< small; +infinity if there is nothing to keep away from
    std::size_t placements = 0;  ///< how many configurations of the arm were looked at: what the verdict cost
};

/// How exactly verify() measures, and how near the ends must be.
struct VerifierOptions
{
    double clearanceTolerance = 1e-4;  ///< > 0, a length; relative to nothing. Cost grows as it shrinks
    double startTolerance = 1e-9;      ///< in radians (slide: length); how far the path's first waypoint may be off
    double goalTolerance = 1e-9;       ///< the same for the last waypoint and a goal given as configuration
};

/// Judges a path continuously, without sampling between waypoints, by geometry code of its own: supporting lines of
/// convex pieces, nothing shared with the checkers it judges.
///
/// \param model, task what is to be solved
/// \param path waypoints in absolute angles (slide first), unwrapped: the motion between neighbours is the straight
/// line between the rows as they stand, so a row may differ from the previous one by more than pi only if the joint
/// turns so far. Start and goal configurations are compared modulo 2 pi for joints without limits.
/// \param options tolerances
/// \throws std::invalid_argument if the task is not one for this robot or a tolerance is not positive
Verdict verify(const PlanarModel &model, const PlanarTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options = {});

/// The same in space, with forward kinematics of its own. The points of a tip path must be reached in their order, each
/// at some waypoint of the path, the last one at its last. Limits are the arm's. The values of joints with a limit,
/// also one that they share with another joint (`UniversalLimit`), are compared as they stand. \throws
/// std::invalid_argument also if a mesh is said to be closed and is not.
Verdict verify(const SpatialModel &model, const SpatialTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options = {});
}  // namespace narrows
