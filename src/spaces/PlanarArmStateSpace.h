// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// Joint space of a planar arm: [slide,] one angle per link in the space's own convention. Joints with limits are
/// bounded; the others do as `FreeJoints` says. Configurations are absolute angles.
///
/// The default projection is the tip of the last link, which the KPIECE family, EST, SBL, PDST and STRIDE need.
class PlanarArmStateSpace final : public ArmStateSpace
{
public:
    static constexpr unsigned int tipDimension = 2;  ///< coordinates of a tip

    /// \throws std::invalid_argument if there are limits in the other convention: they would not be a box here.
    PlanarArmStateSpace(const PlanarArm &arm, AngleConvention convention, FreeJoints freeJoints,
                        const JointLimits &limits);

    /// The arm whose joints these are.
    const PlanarArm &arm() const { return arm_; }
    /// How states count angles.
    AngleConvention convention() const { return convention_; }
    /// The link whose tip the default projection is.
    int lastLink() const { return arm_.linkCount() - 1; }
    /// Where the tip of a link is.
    Eigen::Vector2d tip(const ob::State *state, int link) const;

    ///@{
    /// What ArmStateSpace says of it; configurations are absolute angles.
    void toConfiguration(const ob::State *state, Eigen::VectorXd &q) const override;
    void fromConfiguration(ConfigurationRef q, ob::State *state) const override;
    void displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const override;
    ///@}

    void registerProjections() override;  ///< The tip of the last link as default projection.

private:
    /// Turns values in the space's own convention into absolute ones, in place (linear: works for differences too).
    void accumulate(Eigen::VectorXd &values) const;

    PlanarArm arm_;
    AngleConvention convention_;
};
}  // namespace narrows
