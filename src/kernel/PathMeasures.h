// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// What a path makes of an arm in space and its task: how far it bends, how much of it moves, how well the tip keeps to
/// its path.
struct PathMeasures
{
    /// Largest bend of a universal joint, radians; nothing without such joints.
    std::optional<double> largestBend;
    /// Turning joints that differ from the start by more than 1e-6 rad at some waypoint.
    int movedJoints = 0;
    /// Length of the way of the tip that the goal is about (the last link's, if it is about none), from waypoint to
    /// waypoint.
    double tipLength = 0.0;
    /// For tip paths: largest distance of the tip from the straight line between the points that it has to go between,
    /// looked at eight times per motion. A leg ends at the first waypoint that has reached its point, as for verify();
    /// what comes after the last point reached belongs to the next leg.
    std::optional<double> tipDeviation;
    /// For tip paths that end where the tip was at the start: the largest change of a turning joint from the first to
    /// the last waypoint, radians.
    std::optional<double> closure;
};

/// \param path configurations, not empty; motions between them are straight
PathMeasures measurePath(const SpatialArm &arm, const SpatialTask &task, const std::vector<Eigen::VectorXd> &path);
}  // namespace narrows
