// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/ArmSampler.h"

#include <cmath>

namespace narrows
{
ArmSampler::ArmSampler(const ArmStateSpace *space) : ob::RealVectorStateSampler(space)
{
}

void ArmSampler::sampleUniformNear(ob::State *state, const ob::State *near, double distance)
{
    // A box within the ball of that radius, as OMPL's compound spaces do it: EST, BiEST and STRIDE count and connect
    // neighbours by distance, and with the box around the ball hardly any sample of many joints would be one.
    const double reach = distance / std::sqrt(static_cast<double>(space_->getDimension()));
    sample(state, near, [&](double value) { return rng_.uniformReal(value - reach, value + reach); });
}

void ArmSampler::sampleGaussian(ob::State *state, const ob::State *mean, double deviation)
{
    sample(state, mean, [&](double value) { return rng_.gaussian(value, deviation); });
}

template <typename Draw>
void ArmSampler::sample(ob::State *state, const ob::State *around, const Draw &draw)
{
    const double *center = around->as<ob::RealVectorStateSpace::StateType>()->values;
    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (unsigned int i = 0; i < space_->getDimension(); ++i)
        values[i] = draw(center[i]);
    space_->enforceBounds(state);
}
}  // namespace narrows
