// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "kernel/HomotopyCurve.h"

namespace narrows
{
/// Which part of a slice is looked at, and how closely. Points are z = (s, |D| lambda).
struct SliceWindow
{
    double lambdaMin = -0.3;  ///< where the window begins
    double lambdaMax = 1.3;   ///< where it ends
    double deviation = 4.0;   ///< |s| is looked at up to here, > 0
    int columns = 120;        ///< of the grid along lambda, >= 2
    int rows = 120;           ///< along s, >= 2
    int rings = 40;           ///< around start and goal, each half as wide as the one before; >= 0
    int spokes = 24;          ///< points per ring, >= 3
};

/// Whether a slice has a way, and which.
struct SliceAnswer
{
    bool joins = false;                 ///< is there a way from start to goal in the slice?
    double bottleneck = 0.0;            ///< least clearance of a point on the best such way; 0 without one
    std::vector<Eigen::VectorXd> path;  ///< that way's points z, from start to goal; empty without one
    double spacing = 0.0;               ///< longest edge of the grid, in z: gaps narrower than this may go unseen
};

/// Looks for a way from start to goal in a two-dimensional slice, whatever curve a homotopy has there: so that failures
/// of a homotopy split into those of its slice and those of its curve. The way is the one whose least clearance is the
/// greatest, over a grid and, since ends may be narrow, rings about start and goal.
///
/// `joins` is as good as `isFree`: with an exact motion check it is proven. That nothing joins holds for the spacing.
/// \param clearance of a configuration; positive iff free
/// \param isFree of the straight motion between two configurations
/// \throws std::invalid_argument if the slice has other than two dimensions, or the window is out of range.
SliceAnswer exploreSlice(const HomotopyCurve &slice, const std::function<double(const Eigen::VectorXd &)> &clearance,
                         const std::function<bool(const Eigen::VectorXd &, const Eigen::VectorXd &)> &isFree,
                         const SliceWindow &window = {});
}  // namespace narrows
