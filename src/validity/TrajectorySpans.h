// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "kernel/trajectory/JointTrajectory.h"

namespace narrows
{
/// A trajectory cut at the knots of all its joints, so that within a piece every joint is smooth.
class TrajectorySpans
{
public:
    explicit TrajectorySpans(const JointTrajectory &trajectory);  ///< which outlives this

    /// Ascending, at least two.
    const std::vector<double> &knots() const { return knots_; }
    std::size_t pieces() const { return knots_.size() - 1; }  ///< piece i goes from knot i to knot i + 1

    /// Largest magnitudes of every joint's velocity and acceleration over a span within a piece.
    void bounds(std::size_t piece, const Enclosure &span, Eigen::VectorXd &speeds,
                Eigen::VectorXd &accelerations) const;

private:
    std::vector<std::unique_ptr<PiecewiseMotion>> joints_;
    std::vector<double> knots_;
    std::vector<std::vector<std::size_t>> own_;  ///< per joint and piece: the piece of the joint's own
};
}  // namespace narrows
