// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialArmParts.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Matrix3d;

constexpr double rigidity = 1e-9;  // how far an axis may be from a unit vector, an offset from a rigid motion

[[noreturn]] void refuse(const char *what, std::size_t index, const std::string &why)
{
    throw std::invalid_argument(std::string(what) + " " + std::to_string(index) + ": " + why);
}

bool isRigid(const Isometry3d &motion)
{
    const Matrix3d &linear = motion.linear();
    return motion.matrix().allFinite() && linear.isUnitary(rigidity) && linear.determinant() > 0.0;
}

bool hasRevoluteAncestor(const std::vector<SpatialJoint> &joints, int joint)
{
    for (int i = joints[joint].parent; i >= 0; i = joints[i].parent)
        if (joints[i].kind == SpatialJoint::Kind::Revolute)
            return true;
    return false;
}

void checkJoint(const std::vector<SpatialJoint> &joints, int i)
{
    const SpatialJoint &joint = joints[i];
    if (joint.parent < -1 || joint.parent >= i)
        refuse("joint", i, "the parent must come before the joint");
    if (!(std::abs(joint.axis.norm() - 1.0) < rigidity))
        refuse("joint", i, "the axis must be a unit vector");
    if (!isRigid(joint.offset))
        refuse("joint", i, "the offset must be a rigid motion");
    if (joint.limits && !(joint.limits->lower < joint.limits->upper))
        refuse("joint", i, "the limits must be ordered");
    if (joint.limits && !std::isfinite(joint.limits->upper - joint.limits->lower))
        refuse("joint", i, "the limits must be finite");
    if (joint.kind != SpatialJoint::Kind::Prismatic)
        return;
    if (!joint.limits)
        refuse("joint", i, "a prismatic joint needs limits");
    if (hasRevoluteAncestor(joints, i))
        refuse("joint", i, "a prismatic joint cannot follow a revolute one");
}

void checkLink(const SpatialLink &link, std::size_t i, int jointCount)
{
    if (link.joint < -1 || link.joint >= jointCount)
        refuse("link", i, "its joint does not exist");
    if (!link.from.allFinite() || !link.to.allFinite())
        refuse("link", i, "the ends must be finite");
    if (!(link.radius >= 0.0) || !std::isfinite(link.radius))
        refuse("link", i, "the radius must be finite and not negative");
    if (link.from == link.to && link.radius == 0.0)
        refuse("link", i, "neither extended nor thick");
}

void checkUniversalLimit(const UniversalLimit &limit, std::size_t i, const std::vector<SpatialJoint> &joints)
{
    for (const int joint : {limit.first, limit.second})
        if (joint < 0 || joint >= static_cast<int>(joints.size()) || joints[joint].kind != SpatialJoint::Kind::Revolute)
            refuse("universal limit", i, "it must name revolute joints");
    if (limit.first == limit.second)
        refuse("universal limit", i, "it must name two different joints");
    if (!(limit.maxAngle > 0.0 && limit.maxAngle < std::acos(0.0)))
        refuse("universal limit", i, "the angle must be between 0 and pi / 2");
}
}  // namespace

void checkParts(const std::vector<SpatialJoint> &joints, const std::vector<SpatialLink> &links,
                const std::vector<UniversalLimit> &universalLimits)
{
    if (joints.empty() || links.empty())
        throw std::invalid_argument("an arm needs at least one joint and one link");
    for (std::size_t i = 0; i < joints.size(); ++i)
        checkJoint(joints, static_cast<int>(i));
    for (std::size_t i = 0; i < links.size(); ++i)
        checkLink(links[i], i, static_cast<int>(joints.size()));
    for (std::size_t i = 0; i < universalLimits.size(); ++i)
        checkUniversalLimit(universalLimits[i], i, joints);
}
}  // namespace narrows
