// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/PolynomialTrajectory.h"
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
// The usual polynomials through points at given times, what via-point trajectories are compared with.
//
// points: one column per point, one row per joint. times: of the points. Refused by name: what faultOf() in
// TimedPoints.h finds, and Singular (times differ so much that the solution is rounding).

/// Cubic pieces with continuous velocity and acceleration, at rest at both ends, where acceleration jumps from and
/// to 0.
OrFailure<PolynomialTrajectory> cubicSpline(const Eigen::MatrixXd &points, const std::vector<double> &times);

/// Quintic pieces with four continuous derivatives; velocity and acceleration vanish at both ends.
OrFailure<PolynomialTrajectory> quinticSpline(const Eigen::MatrixXd &points, const std::vector<double> &times);

/// One polynomial of order six through start, via and goal: velocity and acceleration vanish at both ends (the paper's
/// Eq. 27). BadCount unless there are three points.
OrFailure<PolynomialTrajectory> sixthOrder(const Eigen::MatrixXd &points, const std::vector<double> &times);
}  // namespace narrows
