// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "kernel/PlanarModel.h"
#include "spaces/Ompl.h"

namespace narrows
{
/// What a joint without limits does at +-pi.
enum class FreeJoints
{
    Wrapping,  ///< a circle: pi and -pi are one state, motions go the short way round
    Unbounded  ///< a line: winding counts, motions go the way the numbers say; sampled within [-pi, pi]
};

/// Joint space of a planar arm. States are `RealVectorStateSpace::StateType`: [slide,] one angle per link in the
/// space's own convention. Joints with limits are bounded; the others do as `FreeJoints` says.
///
/// Distance is Euclidean over the joint differences (wrapped where joints wrap). The default projection is the tip of
/// the last link, which the KPIECE family, EST, SBL, PDST and STRIDE need.
class PlanarArmStateSpace : public ob::RealVectorStateSpace
{
public:
    /// \throws std::invalid_argument if there are limits in the other convention: they would not be a box here.
    PlanarArmStateSpace(const PlanarArm &arm, AngleConvention convention, FreeJoints freeJoints,
                        const JointLimits &limits);

    const PlanarArm &arm() const { return arm_; }
    AngleConvention convention() const { return convention_; }
    bool wraps(unsigned int joint) const { return wraps_[joint] != 0; }

    /// The state as a configuration in absolute angles.
    void toAbsolute(const ob::State *state, Eigen::VectorXd &q) const;
    /// Writes a configuration in absolute angles into a state; wrapping joints are brought into [-pi, pi].
    void fromAbsolute(ConfigurationRef q, ob::State *state) const;
    /// Absolute-angle displacement of the straight motion between two states (the short way where joints wrap).
    void displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const;
    /// The waypoints in absolute angles, unwrapped as `verify()` wants them.
    std::vector<Eigen::VectorXd> unwrap(const og::PathGeometric &path) const;

    double getMaximumExtent() const override;
    double distance(const ob::State *a, const ob::State *b) const override;
    bool equalStates(const ob::State *a, const ob::State *b) const override;
    void enforceBounds(ob::State *state) const override;
    bool satisfiesBounds(const ob::State *state) const override;
    void interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const override;
    ob::StateSamplerPtr allocDefaultStateSampler() const override;
    void registerProjections() override;

private:
    /// to - from in the space's own convention, the short way for wrapping joints.
    double jointDifference(unsigned int joint, double from, double to) const;
    /// Turns values in the space's own convention into absolute ones, in place (linear: works for differences too).
    void accumulate(Eigen::VectorXd &values) const;

    PlanarArm arm_;
    AngleConvention convention_;
    std::vector<char> wraps_;            ///< per joint; char, because vector<bool> is slow to read
    std::vector<unsigned int> bounded_;  ///< joints with limits
};
}  // namespace narrows
