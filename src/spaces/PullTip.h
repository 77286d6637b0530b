// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SpatialModel.h"
#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
///@{
/// Moves a state, by damped least squares, until the tip of one link is within a tenth of `tolerance` of a point, so
/// that rounding cannot take it out of the tolerance again. The state stays within the joint limits. \return false if
/// it does not get there in 50 steps; the state is then somewhere on the way.
bool pullTip(const PlanarArmStateSpace &space, const TipGoal &goal, ob::State *state);
bool pullTip(const SpatialArmStateSpace &space, const SpatialTipGoal &goal, ob::State *state);
///@}
}  // namespace narrows
