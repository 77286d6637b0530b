// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/TipGoalRegion.h"

#include "spaces/PullTip.h"

namespace narrows
{
template <typename Space, typename TipTarget>
ArmTipGoalRegion<Space, TipTarget>::ArmTipGoalRegion(const ob::SpaceInformationPtr &si, const TipTarget &goal)
  : ob::GoalSampleableRegion(si),
    space_(si->getStateSpace()->as<Space>()),
    goal_(goal),
    sampler_(si->allocStateSampler())
{
    threshold_ = goal.tolerance;
}

template <typename Space, typename TipTarget>
double ArmTipGoalRegion<Space, TipTarget>::distanceGoal(const ob::State *state) const
{
    return (space_->tip(state, goal_.link) - goal_.point).norm();
}

template <typename Space, typename TipTarget>
unsigned int ArmTipGoalRegion<Space, TipTarget>::maxSampleCount() const
{
    // FMT, BIT* and the planners with informed samplers take all samples before they plan.
    return 100;
}

template <typename Space, typename TipTarget>
void ArmTipGoalRegion<Space, TipTarget>::sampleGoal(ob::State *state) const
{
    for (int attempt = 0; attempt < 100; ++attempt)
    {
        sampler_->sampleUniform(state);
        if (pullTip(*space_, goal_, state) && si_->isValid(state))
            return;
    }
}

template class ArmTipGoalRegion<PlanarArmStateSpace, TipGoal>;
template class ArmTipGoalRegion<SpatialArmStateSpace, SpatialTipGoal>;
}  // namespace narrows
