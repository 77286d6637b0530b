// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
/// What shall be least.
enum class TrajectoryObjective
{
    Jerk,
    Acceleration,
    Overshoot,  ///< the jerk decides between equals
    Duration,   ///< under limits; t_v / t_s stays
};

/// What a motion over a via-point should be like.
struct TrajectoryWish
{
    TrajectoryObjective objective = TrajectoryObjective::Jerk;      ///< what shall be least
    double maxOvershoot = std::numeric_limits<double>::infinity();  ///< >= 0, in the unit of the
                                                                    ///< task's positions
    std::optional<MotionLimits> limits;                             ///< to be kept; Duration needs them
    bool mixed = false;     ///< the via's term is Rise::symmetric: other motions,
                            ///< whose jerk begins with a jump
    int evaluations = 200;  ///< > 0, of the global search; the local one may use half as many
};

/// What the search has found.
struct OptimizedTrajectory
{
    ViaPointTrajectory motion;  ///< keeps all that was wished
    MotionPeaks peaks;          ///< of it, to 1e-9
    double viaShape;            ///< > 0, shape of the via's rise
    double goalShape;           ///< > 0, shape of the goal's rise
    int evaluations;            ///< trajectories that were looked at
};

/// The best ViaPointTrajectory::full() (of two Rise::resting, if not mixed)
/// that NLopt finds: DIRECT_L over both shapes, then Nelder-Mead. Every
/// trajectory is judged by its certified extremes, not by samples.
/// Deterministic.
///
/// Fails with what ViaPointTrajectory::full() refuses, BadLimit (limits or
/// maxOvershoot), BadCount (evaluations) or Infeasible.
OrFailure<OptimizedTrajectory> optimizeViaPoint(const ViaPointTask &task, const TrajectoryWish &wish);
}  // namespace narrows
