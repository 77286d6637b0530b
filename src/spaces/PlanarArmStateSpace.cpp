// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/PlanarArmStateSpace.h"

#include <stdexcept>

#include "spaces/TipProjection.h"

namespace narrows
{
namespace
{
std::vector<ArmJoint> jointsOf(const PlanarArm &arm, AngleConvention convention, FreeJoints freeJoints,
                               const JointLimits &limits)
{
    std::vector<ArmJoint> joints;
    if (arm.slide())
        joints.push_back({false, Interval{arm.slide()->lower, arm.slide()->upper}, false});
    for (int link = 0; link < arm.linkCount(); ++link)
    {
        ArmJoint joint;
        if (link < static_cast<int>(limits.angles.size()))
            joint.limits = limits.angles[link];
        if (joint.limits && limits.convention != convention)
            throw std::invalid_argument("the joint limits are meant in the other angle convention");
        joint.wraps = !joint.limits && freeJoints == FreeJoints::Wrapping;
        joints.push_back(joint);
    }
    return joints;
}
}  // namespace

PlanarArmStateSpace::PlanarArmStateSpace(const PlanarArm &arm, AngleConvention convention, FreeJoints freeJoints,
                                         const JointLimits &limits)
  : ArmStateSpace(jointsOf(arm, convention, freeJoints, limits)), arm_(arm), convention_(convention)
{
    setName("PlanarArm" + getName());
}

Eigen::Vector2d PlanarArmStateSpace::tip(const ob::State *state, int link) const
{
    thread_local Eigen::VectorXd q;
    thread_local std::vector<Eigen::Vector2d> points;
    toConfiguration(state, q);
    arm_.place(q, points);
    return points[link + 1];
}

void PlanarArmStateSpace::toConfiguration(const ob::State *state, Eigen::VectorXd &q) const
{
    const double *values = state->as<StateType>()->values;
    q.resize(dimension_);
    for (unsigned int i = 0; i < dimension_; ++i)
        q[i] = values[i];
    accumulate(q);
}

void PlanarArmStateSpace::accumulate(Eigen::VectorXd &values) const
{
    if (convention_ == AngleConvention::Absolute)
        return;
    const int first = arm_.firstAngle();
    for (int i = 0; i < arm_.linkCount(); ++i)
        if (arm_.links()[i].parent >= 0)
            values[first + i] += values[first + arm_.links()[i].parent];
}

void PlanarArmStateSpace::fromConfiguration(ConfigurationRef q, ob::State *state) const
{
    const Eigen::VectorXd own = arm_.fromAbsolute(q, convention_);
    double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
        values[i] = wrapped(i, own[i]);
}

void PlanarArmStateSpace::displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const
{
    const double *a = from->as<StateType>()->values;
    const double *b = to->as<StateType>()->values;
    delta.resize(dimension_);
    for (unsigned int i = 0; i < dimension_; ++i)
        delta[i] = jointDifference(i, a[i], b[i]);
    accumulate(delta);
}

void PlanarArmStateSpace::registerProjections()
{
    // A twentieth of the reach: about a thousand cells over all that the tip can reach.
    registerDefaultProjection(std::make_shared<TipProjection<PlanarArmStateSpace>>(this, 20));
}
}  // namespace narrows
