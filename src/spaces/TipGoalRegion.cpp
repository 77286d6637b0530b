// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/TipGoalRegion.h"

#include <limits>

#include <Eigen/LU>

#include "kernel/TipJacobian.h"

namespace narrows
{
TipGoalRegion::TipGoalRegion(const ob::SpaceInformationPtr &si, const TipGoal &goal)
  : ob::GoalSampleableRegion(si)
  , space_(si->getStateSpace()->as<PlanarArmStateSpace>())
  , goal_(goal)
  , sampler_(si->allocStateSampler())
{
    threshold_ = goal.tolerance;
}

double TipGoalRegion::distanceGoal(const ob::State *state) const
{
    Eigen::VectorXd q;
    std::vector<Eigen::Vector2d> points;
    space_->toAbsolute(state, q);
    space_->arm().place(q, points);
    return (points[goal_.link + 1] - goal_.point).norm();
}

unsigned int TipGoalRegion::maxSampleCount() const
{
    return std::numeric_limits<unsigned int>::max();
}

void TipGoalRegion::sampleGoal(ob::State *state) const
{
    for (int attempt = 0; attempt < 100; ++attempt)
    {
        sampler_->sampleUniform(state);
        if (pull(state) && si_->isValid(state))
            return;
    }
}

bool TipGoalRegion::pull(ob::State *state) const
{
    Eigen::VectorXd q;
    std::vector<Eigen::Vector2d> points;
    Eigen::Matrix2Xd jacobian;
    const double damping = 1e-4 * space_->arm().reach() * space_->arm().reach();
    for (int iteration = 0; iteration < 50; ++iteration)
    {
        space_->toAbsolute(state, q);
        space_->arm().place(q, points);
        const Eigen::Vector2d error = goal_.point - points[goal_.link + 1];
        // Well inside the tolerance, so that rounding cannot take a sample out of the goal again.
        if (error.norm() <= 0.1 * goal_.tolerance)
            return true;
        tipJacobian(space_->arm(), q, goal_.link, jacobian);
        const Eigen::Matrix2d damped = jacobian * jacobian.transpose() + damping * Eigen::Matrix2d::Identity();
        q += jacobian.transpose() * damped.inverse() * error;
        space_->fromAbsolute(q, state);
        space_->enforceBounds(state);
    }
    return false;
}
}  // namespace narrows
