// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/TipGoalRegion.h"

#include "spaces/PullTip.h"

namespace narrows
{
TipGoalRegion::TipGoalRegion(const ob::SpaceInformationPtr &si, const TipGoal &goal)
  : ob::GoalSampleableRegion(si),
    space_(si->getStateSpace()->as<PlanarArmStateSpace>()),
    goal_(goal),
    sampler_(si->allocStateSampler())
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
    // FMT, BIT* and the planners with informed samplers take all samples before they plan.
    return 100;
}

void TipGoalRegion::sampleGoal(ob::State *state) const
{
    for (int attempt = 0; attempt < 100; ++attempt)
    {
        sampler_->sampleUniform(state);
        if (pullTip(*space_, goal_, state) && si_->isValid(state))
            return;
    }
}
}  // namespace narrows
