// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernel/CircleObstacle.h"
#include "kernel/LinkPair.h"
#include "kernel/PlanarModel.h"

namespace narrows
{
/// One side of a joint's limits, linear in the configuration: C = sign * (q[joint] - q[parent] - bound).
struct LimitPole
{
    double sign;   ///< +1 above a lower bound, -1 below an upper one
    int joint;     ///< index in the configuration
    int parent;    ///< of the angle that this one is counted against; -1: none
    double bound;  ///< radians, or length of a slide

    /// C; negative beyond the limit.
    double value(ConfigurationRef q) const { return sign * (q[joint] - (parent < 0 ? 0.0 : q[parent]) - bound); }
};

/// Two links that must not touch each other.
struct SelfPair
{
    int first;   ///< index of a link
    int second;  ///< index of the other
};

/// All that a planar arm can have poles of, worked out once and shared by every DistanceRepulsion of the arm.
class PlanarPoles
{
public:
    /// \throws std::invalid_argument if there are more joint limits than links
    PlanarPoles(const PlanarModel &model, const JointLimits &limits);

    const PlanarArm &arm() const { return arm_; }  ///< the arm they are of
    /// One per obstacle of the model.
    const std::vector<std::unique_ptr<const LinkObstacle>> &obstacles() const { return obstacles_; }
    const std::vector<LimitPole> &limits() const { return limits_; }  ///< sides of joint limits that are finite
    const std::vector<SelfPair> &pairs() const { return pairs_; }     ///< of links that must not touch
    /// The names that RepulsionModel::groups promises.
    const std::vector<std::string> &groups() const { return groups_; }
    int limitGroup() const { return limitGroup_; }  ///< index of "limits"; -1 if there are none
    int selfGroup() const { return selfGroup_; }    ///< index of "self"; -1 if there are no pairs
    /// `size` of pairPole() for all pairs.
    double pairSize() const { return pairSize_; }

    /// Where the links lie, given what PlanarArm::place() yields.
    void segments(const std::vector<Eigen::Vector2d> &points, std::vector<Segment> &links) const;

private:
    void addLimits(const JointLimits &limits);

    PlanarArm arm_;
    std::vector<double> inverseSquares_;  ///< 1 / length^2 per link
    std::vector<std::unique_ptr<const LinkObstacle>> obstacles_;
    std::vector<LimitPole> limits_;
    std::vector<SelfPair> pairs_;
    std::vector<std::string> groups_;
    int limitGroup_ = -1;
    int selfGroup_ = -1;
    double pairSize_;
};
}  // namespace narrows
