// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/scaling/ScalingProblem.h"

namespace narrows
{
/// Poses of a chain as the scaling method has them, joint centres in the slide frame, and as its joint values.
class PoseTranslator
{
public:
    /// The chain is referred to.
    explicit PoseTranslator(const ChainGeometry &chain) : chain_(chain), axes_(slideAxes(chain)) {}

    /// A point of the world in the slide frame (ScalingProblem).
    Eigen::Vector3d toSlideFrame(const Eigen::Vector3d &point) const
    {
        return axes_.transpose() * (point - chain_.origin);
    }

    /// Joint centres O_1 .. O_{n+1} in the slide frame. \pre `arm` is the chain's
    void toCentres(const SpatialArm &arm, const Eigen::VectorXd &values, std::vector<Eigen::Vector3d> &centres) const
    {
        jointCentres(arm, values, centres);
        for (Eigen::Vector3d &centre : centres)
            centre = toSlideFrame(centre);
    }

    /// Joint values that put the n + 1 centres, in the slide frame, where they shall be.
    /// \return false if there are none (valuesFromCentres()); `values` is as it was then
    bool toValues(const Eigen::Vector3d *centres, Eigen::VectorXd &values)
    {
        world_.resize(chain_.lengths.size() + 1);
        for (std::size_t i = 0; i < world_.size(); ++i)
            world_[i] = chain_.origin + axes_ * centres[i];
        return valuesFromCentres(chain_, world_, values);
    }

private:
    const ChainGeometry &chain_;
    Eigen::Matrix3d axes_;
    std::vector<Eigen::Vector3d> world_;
};
}  // namespace narrows
