// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "spaces/PlanarArmStateSpace.h"

namespace narrows
{
/// The states whose tip is within a tolerance of a point. Samples are random states pulled onto the point by damped
/// least squares and brought within the joint limits; only free ones are given out.
class TipGoalRegion : public ob::GoalSampleableRegion
{
public:
    /// \pre the state space of `si` is a PlanarArmStateSpace and `goal.link` one of its links.
    TipGoalRegion(const ob::SpaceInformationPtr &si, const TipGoal &goal);

    /// How far the tip is from the point.
    double distanceGoal(const ob::State *state) const override;

    /// If no free state is found in 100 tries, the last try is given out, wherever it is; planners check validity.
    void sampleGoal(ob::State *state) const override;
    unsigned int maxSampleCount() const override;

private:
    const PlanarArmStateSpace *space_;
    TipGoal goal_;
    ob::StateSamplerPtr sampler_;
};
}  // namespace narrows
