// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/Record.h"
#include "kernel/trajectory/JointTrajectory.h"
#include "validity/TrajectoryCertificate.h"

namespace narrows
{
/// Says which motions of a run's robot are proven free of collisions and within its limits, whatever the run itself
/// checks motions by. Joints count as in the scenario's file, unwrapped: full turns are motions.
class ProvenMotions
{
public:
    explicit ProvenMotions(const RunSpec &spec);

    bool isFree(const JointTrajectory &motion) const;
    /// \param polyline one column per vertex
    bool isFree(const Eigen::MatrixXd &polyline) const;

    /// The polyline with vertices left out that it can do without, from the start on: each time as many as a straight
    /// motion, proven free, leads past. \param vertices one per column, of a free polyline
    Eigen::MatrixXd withShortcuts(const Eigen::MatrixXd &vertices) const;

private:
    bool isFreeBetween(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const;

    std::shared_ptr<const Scenario> scenario_;
    Problem problem_;
    TrajectoryCertificate certificate_;
};
}  // namespace narrows
