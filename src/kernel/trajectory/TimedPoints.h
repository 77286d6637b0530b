// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
/// The longest duration of a motion.
constexpr double longestTime = 1e6;

/// Why there is no motion through these points at these times; None if there is. BadCount unless there is a joint
/// (row), two points (columns) and a time for each; BadTime unless times begin with 0 and ascend, by more than 1e-9 of
/// the last, up to longestTime.
TrajectoryFailure faultOf(const Eigen::MatrixXd &points, const std::vector<double> &times);
}  // namespace narrows
