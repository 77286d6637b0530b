// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmTravel.h"

#include <stdexcept>

#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
namespace
{
double planarBound(const PlanarArm &arm, const Eigen::VectorXd &changes)
{
    thread_local Eigen::VectorXd ways, bends;
    arm.motionBounds(changes, ways, bends);
    return ways.maxCoeff();
}

/// Slides are taken apart from turns: motionBounds() adds them as vectors, which can cancel; in another direction of
/// the same changes they would not.
double spatialBound(const SpatialArm &arm, const Eigen::VectorXd &changes)
{
    thread_local Eigen::VectorXd turning, ways, bends, turns;
    turning = changes;
    double slides = 0.0;
    for (int i = 0; i < arm.dimension(); ++i)
        if (arm.joints()[static_cast<std::size_t>(i)].kind == SpatialJoint::Kind::Prismatic)
        {
            slides += changes[i];
            turning[i] = 0.0;
        }
    arm.motionBounds(turning, ways, bends, turns);
    return slides + ways.maxCoeff();
}
}  // namespace

ArmTravel::ArmTravel(const ArmStateSpace &space, bool selfCollision) : factor_(selfCollision ? 2.0 : 1.0)
{
    if (const auto *planar = dynamic_cast<const PlanarArmStateSpace *>(&space))
    {
        reach_ = planar->arm().reach();
        bound_ = [arm = planar->arm()](const Eigen::VectorXd &changes)
        {
            return planarBound(arm, changes);
        };
    }
    else if (const auto *spatial = dynamic_cast<const SpatialArmStateSpace *>(&space))
    {
        reach_ = spatial->arm().reach();
        bound_ = [arm = spatial->arm()](const Eigen::VectorXd &changes)
        {
            return spatialBound(arm, changes);
        };
    }
    else
        throw std::invalid_argument("how far a robot's points travel is known for planar and spatial arms only");
}
}  // namespace narrows
