// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/JointStateSpace.h"
#include "spaces/UniversalRange.h"

namespace narrows
{
/// Joint space of a spatial arm: one value per joint, which is the kernel's configuration too. Joints with limits are
/// bounded, the pairs of universal joints to their cones as well; the others do as `FreeJoints` says.
///
/// All limits together are a convex set: the straight motion between two states within them stays within them. Samples
/// are uniform in it. The default projection is the tip of the last link.
class SpatialArmStateSpace final : public JointStateSpace
{
public:
    static constexpr unsigned int tipDimension = 3;  ///< coordinates of a tip

    /// \throws std::invalid_argument if a joint belongs to two universal joints, or limits leave one no position.
    SpatialArmStateSpace(const SpatialArm &arm, FreeJoints freeJoints);

    /// The arm whose joints these are.
    const SpatialArm &arm() const { return arm_; }
    /// The limits that two joints share.
    const std::vector<UniversalRange> &universalRanges() const { return universal_; }
    /// The last link that joints move.
    int lastLink() const;
    /// Where the end of a link is.
    Eigen::Vector3d tip(const ob::State *state, int link) const;

    ///@{
    /// What ob::StateSpace says of it, with the limits that two joints share.
    void enforceBounds(ob::State *state) const override;
    bool satisfiesBounds(const ob::State *state) const override;
    ob::StateSamplerPtr allocDefaultStateSampler() const override;
    ///@}
    void registerProjections() override;  ///< The tip of the last link as default projection.

private:
    SpatialArmStateSpace(const SpatialArm &arm, std::vector<UniversalRange> universal, FreeJoints freeJoints);

    SpatialArm arm_;
    std::vector<UniversalRange> universal_;
};
}  // namespace narrows
