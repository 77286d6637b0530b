// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/SpatialPoles.h"

namespace narrows
{
/// What a posture is wished for.
struct PostureWishOptions
{
    double bendGain = 0.1;      ///< in [0, 1]: share of its bend that a joint would lose in one step
    double obstacleGain = 0.5;  ///< in [0, 1]: share of the missing clearance that a link would win in one step
    double influence = 0.0;     ///< >= 0, a length: clearance that links would like to have
};

/// The motion that an arm would make for a better posture, were it not for its tip: straighter joints, and links
/// further away from obstacles that they are near to. Straighter joints are all that keeps links away from each other:
/// those of a chain are near its next but one whatever it does.
///
/// Universal joints unbend along the gradient of 1 - cos(first) cos(second), other turning joints towards the middle of
/// their limits, or zero without. Prismatic joints only move for the sake of obstacles.
class PostureWish
{
public:
    /// \param poles of the arm, not null
    PostureWish(std::shared_ptr<const SpatialPoles> poles, const PostureWishOptions &options);

    /// \param motion resized; radians, lengths for prismatic joints
    void operator()(ConfigurationRef q, const SpatialArm::Placement &placement, Eigen::VectorXd &motion);

private:
    void unbend(ConfigurationRef q, Eigen::VectorXd &motion) const;
    void keepAway(const SpatialArm::Placement &placement, Eigen::VectorXd &motion);
    /// The motion that brings clearance to what is at distance `clearance` and changes with the links by forces_.
    void retreat(const SpatialArm::Placement &placement, double clearance, Eigen::VectorXd &motion);

    std::shared_ptr<const SpatialPoles> poles_;
    PostureWishOptions options_;
    Eigen::VectorXd units_;
    std::vector<int> alone_;  ///< turning joints that belong to no universal joint
    std::vector<EndForces> forces_;
    Eigen::VectorXd gradient_;
};
}  // namespace narrows
