// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "benchmark/Record.h"
#include "kernel/trajectory/JointTrajectory.h"
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
/// "v,a,j": the largest velocity, acceleration and jerk of every joint, in rad (lengths for sliding joints) and
/// seconds.
///
/// \throws std::invalid_argument unless the text is three positive, finite numbers
MotionLimits limitsFromText(const std::string &text);

/// How fast a robot can follow a path. Planners leave paths of few and of very many waypoints: corners are left out as
/// long as the straight motion past them is proven free, from the start on, and from the goal on. Then
/// smoothTrajectory() cuts what corners it may, of these polylines, of the path itself if it has few, and of the
/// polyline that a planner made a smooth path from. Where the tip must follow a path, nothing is left out or cut.
struct PathTiming
{
    std::unique_ptr<JointTrajectory> motion;  ///< the fastest that is proven free of collisions
    std::string method;                       ///< "stop and go", or "overlapped moves" where corners could be cut
    double stopDuration;             ///< of the fastest motion that stops at the corners of one of these polylines
    std::vector<MotionPeaks> peaks;  ///< of the motion; certified
};

/// \param record of a solved run of this spec \param limits of every joint, as the scenario's file counts joints
/// Fails with NoMotion if the path does not move, BadTime if it takes a joint longer than 1e6 s.
OrFailure<PathTiming> timePath(const RunSpec &spec, const Record &record, const MotionLimits &limits);

/// Writes duration and peaks into the record of a solved run of a spec with limits.
void recordTiming(const RunSpec &spec, Record &record);
}  // namespace narrows
