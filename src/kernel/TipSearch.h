// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/SpatialArm.h"

namespace narrows
{
/// How a search for a tip ended.
enum class TipSearchStatus
{
    Reached,
    AtLimit,       ///< not reached, and a joint's limit was in the way when the search gave up
    NoConvergence  ///< not reached
};

/// How a search for a tip ended, and what it cost.
struct TipSearchResult
{
    TipSearchStatus status;  ///< whether the tip is where it should be
    int iterations;          ///< how often the arm was placed
};

/// What a tip is asked for, whatever the target.
struct TipSearchTask
{
    int link;           ///< whose end is meant
    double precision;   ///< > 0, a length: how near the end has to come
    int maxIterations;  ///< > 0
    /// Brings a configuration within the joint limits; whether it was outside. May change nothing.
    std::function<bool(Eigen::VectorXd &)> enforceLimits;
};

/// Inverse kinematics by iteration, from one target to the next.
class TipSearch
{
public:
    virtual ~TipSearch() = default;

    /// \param q where to begin; a configuration whose tip is near `target` if Reached, else somewhere on the way.
    /// Within the limits, if it was so before
    virtual TipSearchResult reach(const Eigen::Vector3d &target, Eigen::VectorXd &q) = 0;
};

/// What one unit of a search is for each joint: a radian, or for prismatic joints the arm's reach, which moves a tip as
/// far.
Eigen::VectorXd jointUnits(const SpatialArm &arm);
}  // namespace narrows
