// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialTerm.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// What acts on a joint and all that it carries: a force and its moment about the origin.
struct Wrench
{
    Vector3d force = Vector3d::Zero();
    Vector3d moment = Vector3d::Zero();

    void push(const Vector3d &point, const Vector3d &part)
    {
        force += part;
        moment += point.cross(part);
    }
};
}  // namespace

void gatherGradient(const SpatialArm &arm, const SpatialArm::Placement &placement, const std::vector<EndForces> &forces,
                    Eigen::VectorXd &gradient)
{
    static thread_local std::vector<Wrench> wrenches;
    wrenches.assign(arm.joints().size(), {});
    for (int i = 0; i < arm.linkCount(); ++i)
        if (const int joint = arm.links()[i].joint; joint >= 0)
        {
            wrenches[joint].push(placement.points[2 * i], forces[i].a);
            wrenches[joint].push(placement.points[2 * i + 1], forces[i].b);
        }
    gradient.resize(arm.dimension());
    for (int i = arm.dimension() - 1; i >= 0; --i)
    {
        const SpatialJoint &joint = arm.joints()[i];
        const Eigen::Isometry3d &frame = placement.frames[i];
        const Wrench &wrench = wrenches[i];
        const Vector3d axis = frame.linear() * joint.axis;
        if (joint.kind == SpatialJoint::Kind::Prismatic)
            gradient[i] = axis.dot(wrench.force);
        else
            gradient[i] = axis.dot(wrench.moment - frame.translation().cross(wrench.force));
        if (joint.parent >= 0)
        {
            wrenches[joint.parent].force += wrench.force;
            wrenches[joint.parent].moment += wrench.moment;
        }
    }
}
}  // namespace narrows
