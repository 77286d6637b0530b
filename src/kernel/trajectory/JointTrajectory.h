// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <Eigen/Core>

#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// A timed motion of several joints, from time 0 to its duration; before and after it they rest.
class JointTrajectory
{
public:
    /// Position, velocity, acceleration and jerk, one column each; one row per joint.
    using States = Eigen::Matrix<double, Eigen::Dynamic, 4>;

    virtual ~JointTrajectory() = default;

    virtual Eigen::Index joints() const = 0;  ///< How many joints move.
    /// > 0.
    virtual double duration() const = 0;
    /// What all joints do at a time; where derivatives jump, one of the two limits.
    /// \param t seconds, if limits were per second \param state resized as needed
    virtual void at(double t, States &state) const = 0;
    /// One joint's motion, for certified bounds. It refers to this trajectory.
    virtual std::unique_ptr<PiecewiseMotion> joint(Eigen::Index index) const = 0;
};
}  // namespace narrows
