// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/PullTip.h"

#include <algorithm>

#include <Eigen/LU>

#include "kernel/TipJacobian.h"

namespace narrows
{
namespace
{
constexpr double longestMove = 0.5;  ///< per step; radians, and length units of a slide
}  // namespace

bool pullTip(const PlanarArmStateSpace &space, const TipGoal &goal, ob::State *state)
{
    Eigen::VectorXd q;
    std::vector<Eigen::Vector2d> points;
    Eigen::Matrix2Xd jacobian;
    const double damping = 1e-4 * space.arm().reach() * space.arm().reach();
    for (int step = 0; step < 50; ++step)
    {
        space.toAbsolute(state, q);
        space.arm().place(q, points);
        const Eigen::Vector2d error = goal.point - points[goal.link + 1];
        if (error.norm() <= 0.1 * goal.tolerance)
            return true;
        tipJacobian(space.arm(), q, goal.link, jacobian);
        const Eigen::Matrix2d damped = jacobian * jacobian.transpose() + damping * Eigen::Matrix2d::Identity();
        const Eigen::VectorXd move = jacobian.transpose() * damped.inverse() * error;
        // Near singular postures the full step would wind joints round and round.
        q += std::min(1.0, longestMove / move.norm()) * move;
        space.fromAbsolute(q, state);
        space.enforceBounds(state);
    }
    return false;
}
}  // namespace narrows
