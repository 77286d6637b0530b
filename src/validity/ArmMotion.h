// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarArm.h"

namespace narrows
{
/// Where an arm is on the straight way between two rows of a path, and how far it can get from there: the verifier's
/// own kinematics. Point 0 is the arm's base and point i + 1 the tip of link i.
class ArmMotion
{
public:
    explicit ArmMotion(const PlanarArm &arm);

    /// Goes to from + t * (to - from).
    void place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t);

    int tipOf(int link) const { return link + 1; }
    int baseOf(int link) const { return arm_.links()[link].parent + 1; }
    const Eigen::Vector2d &point(int index) const { return points_[index].position; }

    /// How far a point moves at most while t changes by up to `half`.
    double travel(int index, double half) const { return points_[index].travel * half; }

    /// How far it moves at most along the line with the unit direction u: to second order, which is far less than
    /// `travel` for a point that glides past a wall. Everything on a link moves along u at most as far as the link's
    /// worse end.
    double travelAlong(int index, const Eigen::Vector2d &u, double half) const;

private:
    struct MovingPoint
    {
        Eigen::Vector2d position;
        Eigen::Vector2d velocity;  ///< d position / dt
        double travel;             ///< bound of the speed
        double bend;               ///< bound of the acceleration
    };

    const PlanarArm &arm_;
    std::vector<MovingPoint> points_;
};
}  // namespace narrows
