// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/PolynomialTrajectory.h"
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
// Motions that follow a polyline exactly and stop at every vertex: what any path can be driven by. On a segment all
// joints move in proportion. Vertices that repeat the one before are passed over.
//
// points: one column per vertex, one row per joint. limits: one for each joint. Refused by name: BadCount, NotFinite,
// BadLimit, NoMotion (all vertices are equal), BadTime (more than 1e6 for a segment).

/// Without vertices that repeat their predecessor up to 1e-12 of the largest coordinate; the last one is kept.
Eigen::MatrixXd distinctVertices(const Eigen::MatrixXd &points);

/// Of distinctVertices() those where the polyline bends: a vertex that lies on the straight line between the corner
/// before and the vertex behind it, up to 1e-12 of the largest coordinate, is none.
Eigen::MatrixXd polylineCorners(const Eigen::MatrixXd &points);

/// Every segment as fast as velocity, acceleration and jerk allow (fastestMove); no stop-and-go is faster.
OrFailure<PolynomialTrajectory> sevenPhaseStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits);

/// Every segment is a quintic step, 10 x^3 - 15 x^4 + 6 x^5, as fast as the limits allow.
OrFailure<PolynomialTrajectory> quinticStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits);

/// Every segment has a trapezoid of velocity (or a triangle), as fast as velocity and acceleration allow. Acceleration
/// jumps, so that jerk is infinite: its limit is checked for being one, and not kept.
OrFailure<PolynomialTrajectory> trapezoidStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits);

/// Linear segments with parabolic blends, in given times: velocity rises evenly for a third of the segment's time,
/// stays, and falls. Peaks of a unit move in unit time are 1.5 and 4.5, and infinite jerk.
/// \param times of the vertices: 0 first, ascending, up to 1e6; else BadTime
/// \throws std::invalid_argument if a vertex repeats its predecessor
OrFailure<PolynomialTrajectory> parabolicBlends(const Eigen::MatrixXd &points, const std::vector<double> &times);

/// When sevenPhaseStops() is at the vertices: sensible times for splines through them.
/// \throws std::invalid_argument if a vertex repeats its predecessor
OrFailure<std::vector<double>> stopTimes(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits);
}  // namespace narrows
