// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <boost/math/constants/constants.hpp>

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

/// What a space knows of one joint.
struct ArmJoint
{
    bool turns = true;               ///< revolute: radians; else prismatic: a length
    std::optional<Interval> limits;  ///< none: a revolute joint that turns freely
    bool wraps = false;              ///< only without limits
};

/// Joint space of an arm. States are `RealVectorStateSpace::StateType`: one value per joint, as the space counts them.
/// A CONFIGURATION is the same posture as the kernel counts it (planar arms: absolute angles); the map between the two
/// is linear, so that straight motions are straight in both.
///
/// Distance is Euclidean over the joint differences (wrapped where joints wrap).
class ArmStateSpace : public ob::RealVectorStateSpace
{
public:
    /// Is this joint a circle, on which pi and -pi are the same?
    bool wraps(unsigned int joint) const { return wraps_[joint] != 0; }
    /// One per dimension.
    const std::vector<ArmJoint> &joints() const { return joints_; }

    /// Sets q, resized as needed, to the configuration of a state.
    virtual void toConfiguration(const ob::State *state, Eigen::VectorXd &q) const = 0;
    /// Wrapping joints are brought into [-pi, pi].
    virtual void fromConfiguration(ConfigurationRef q, ob::State *state) const = 0;
    /// Way of the configuration over the straight motion between two states (the short way where joints wrap).
    virtual void displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const = 0;
    /// The waypoints as configurations, unwrapped as `verify()` wants them.
    std::vector<Eigen::VectorXd> unwrap(const og::PathGeometric &path) const;

    ///@{
    /// What ob::StateSpace says of it, with joints that wrap.
    double getMaximumExtent() const override;
    double distance(const ob::State *a, const ob::State *b) const override;
    bool equalStates(const ob::State *a, const ob::State *b) const override;
    void enforceBounds(ob::State *state) const override;
    bool satisfiesBounds(const ob::State *state) const override;
    void interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const override;
    ob::StateSamplerPtr allocDefaultStateSampler() const override;
    ///@}

protected:
    /// \pre joints are not empty, those that do not turn have limits, and limits are ordered
    explicit ArmStateSpace(std::vector<ArmJoint> joints);

    /// to - from as the space counts, the short way for wrapping joints.
    double jointDifference(unsigned int joint, double from, double to) const
    {
        // Values of states lie in [-pi, pi], so that one turn at most has to be taken off.
        const double difference = to - from;
        if (!wraps_[joint] || std::abs(difference) <= pi)
            return difference;
        return difference > 0.0 ? difference - 2.0 * pi : difference + 2.0 * pi;
    }
    /// The angle in [-pi, pi] of a joint that wraps; of any other, the value itself.
    double wrapped(unsigned int joint, double value) const
    {
        return !wraps_[joint] || std::abs(value) <= pi ? value : std::remainder(value, 2.0 * pi);
    }

private:
    static constexpr double pi = boost::math::constants::pi<double>();

    std::vector<ArmJoint> joints_;
    std::vector<char> wraps_;            ///< per joint; char, because vector<bool> is slow to read
    std::vector<unsigned int> bounded_;  ///< joints with limits
};
}  // namespace narrows
