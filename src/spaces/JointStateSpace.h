// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// Joint space of any robot: a configuration is what the state says. For whoever brings a robot of his own, and for
/// spaces that know more of theirs.
class JointStateSpace : public ArmStateSpace
{
public:
    /// \throws std::invalid_argument if there are no joints, or one that neither turns nor has limits
    explicit JointStateSpace(const std::vector<ArmJoint> &joints);

    ///@{
    /// What ArmStateSpace says of it.
    void toConfiguration(const ob::State *state, Eigen::VectorXd &q) const override;
    void fromConfiguration(ConfigurationRef q, ob::State *state) const override;
    void displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const override;
    ///@}
};

/// A space's values as joints: the space itself if it is an ArmStateSpace; for any other RealVectorStateSpace, joints
/// that slide between its bounds as they are now (or do not end, where it has none), with which its own states can be
/// read and written. Null for spaces of any other kind, and for one without dimensions.
std::shared_ptr<const ArmStateSpace> jointsOf(const ob::StateSpacePtr &space);
}  // namespace narrows
