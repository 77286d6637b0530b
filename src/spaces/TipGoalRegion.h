// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "kernel/SpatialModel.h"
#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
/// The states whose tip is within a tolerance of a point. Samples are random states pulled onto the point by damped
/// least squares and brought within the joint limits; only free ones are given out.
/// \tparam Space PlanarArmStateSpace or SpatialArmStateSpace
/// \tparam TipTarget TipGoal or SpatialTipGoal
template <typename Space, typename TipTarget>
class ArmTipGoalRegion : public ob::GoalSampleableRegion
{
public:
    /// \pre the state space of `si` is a `Space` and `goal.link` one of its links.
    ArmTipGoalRegion(const ob::SpaceInformationPtr &si, const TipTarget &goal);

    /// Which tip shall be where.
    const TipTarget &goal() const { return goal_; }

    /// How far the tip is from the point.
    double distanceGoal(const ob::State *state) const override;

    /// If no free state is found in 100 tries, the last try is given out, wherever it is; planners check validity.
    void sampleGoal(ob::State *state) const override;
    unsigned int maxSampleCount() const override;  ///< As many as an unsigned int can count.

private:
    const Space *space_;
    TipTarget goal_;
    ob::StateSamplerPtr sampler_;
};

using TipGoalRegion = ArmTipGoalRegion<PlanarArmStateSpace, TipGoal>;  ///< in the plane
/// in space
using SpatialTipGoalRegion = ArmTipGoalRegion<SpatialArmStateSpace, SpatialTipGoal>;
}  // namespace narrows
