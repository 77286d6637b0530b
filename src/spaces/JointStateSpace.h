// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

    void toConfiguration(const ob::State *state, Eigen::VectorXd &q) const override;
    void fromConfiguration(ConfigurationRef q, ob::State *state) const override;
    void displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const override;
};
}  // namespace narrows
