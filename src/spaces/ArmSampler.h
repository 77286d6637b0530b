// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// Uniform over the bounds; around a state, wrapping joints wrap instead of piling up at the seam.
class ArmSampler : public ob::RealVectorStateSampler
{
public:
    explicit ArmSampler(const ArmStateSpace *space);  ///< of a space that outlives it

    /// Uniform over a box within the ball of radius `distance`, brought into the bounds: OMPL's planners count on
    /// neighbours not being further away.
    void sampleUniformNear(ob::State *state, const ob::State *near, double distance) override;
    /// Normal in every joint, independently, brought into the bounds.
    void sampleGaussian(ob::State *state, const ob::State *mean, double deviation) override;

private:
    template <typename Draw>
    void sample(ob::State *state, const ob::State *around, const Draw &draw);
};
}  // namespace narrows
