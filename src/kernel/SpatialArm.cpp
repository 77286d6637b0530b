// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialArm.h"

#include <algorithm>
#include <cmath>

#include "kernel/SpatialArmParts.h"
#include "kernel/SpatialNeighbours.h"

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d crossMatrix(const Vector3d &v)
{
    Matrix3d cross;
    cross << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return cross;
}

/// What the passes from the base to the tips know of a joint. Kept per thread, so that its memory is used again.
struct JointBounds
{
    double way = 0.0;   // of the frame's origin, slides left out
    double bend = 0.0;  // of the frame's origin
    double turn = 0.0;  // sum of the revolute rates up to this joint
    Vector3d slide = Vector3d::Zero();
};

struct JointVelocity
{
    Vector3d linear = Vector3d::Zero();  // of the frame's origin
    Vector3d angular = Vector3d::Zero();
};
}  // namespace

SpatialArm::SpatialArm(std::vector<SpatialJoint> joints, std::vector<SpatialLink> links,
                       std::vector<UniversalLimit> universalLimits)
  : joints_(std::move(joints)), links_(std::move(links)), universalLimits_(std::move(universalLimits))
{
    checkParts(joints_, links_, universalLimits_);
    for (int i = 0; i < dimension(); ++i)
        prepareJoint(i);
    for (int i = 0; i < linkCount(); ++i)
        prepareLink(i);
    measureReach();
    Placement atZero;
    place(Eigen::VectorXd::Zero(dimension()), atZero);
    neighbours_ = findNeighbours(*this, atZero);
}

SpatialArm::Lever SpatialArm::lever(int joint, const Vector3d &vector) const
{
    if (joint < 0)
        return {vector.norm(), vector.norm()};
    return {vector.norm(), joints_[joint].axis.cross(vector).norm()};
}

void SpatialArm::prepareJoint(int i)
{
    const SpatialJoint &joint = joints_[i];
    const Matrix3d turn = joint.offset.linear() * crossMatrix(joint.axis);
    rotations_.push_back({joint.offset.linear(), turn, turn * crossMatrix(joint.axis)});
    hops_.push_back(lever(joint.parent, joint.offset.translation()));
    Vector3d direction = joint.axis;
    for (int k = i; k >= 0; k = joints_[k].parent)
        direction = joints_[k].offset.linear() * direction;
    directions_.push_back(direction);
}

void SpatialArm::prepareLink(int i)
{
    const Lever from = lever(links_[i].joint, links_[i].from);
    const Lever to = lever(links_[i].joint, links_[i].to);
    extents_.push_back({std::max(from.length, to.length), std::max(from.perpendicular, to.perpendicular)});
}

void SpatialArm::measureReach()
{
    std::vector<double> far(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
        const SpatialJoint &joint = joints_[i];
        far[i] = joint.parent < 0 ? 0.0 : far[joint.parent] + hops_[i].length;
        if (joint.kind == SpatialJoint::Kind::Prismatic)
            far[i] += std::max(std::abs(joint.limits->lower), std::abs(joint.limits->upper));
    }
    for (std::size_t i = 0; i < links_.size(); ++i)
        reach_ = std::max(reach_,
                          extents_[i].length + links_[i].radius + (links_[i].joint < 0 ? 0.0 : far[links_[i].joint]));
}

void SpatialArm::place(const Eigen::Ref<const Eigen::VectorXd> &q, Placement &placement) const
{
    placement.frames.resize(joints_.size());
    placement.points.resize(2 * links_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
        const SpatialJoint &joint = joints_[i];
        Isometry3d &frame = placement.frames[i];
        Vector3d origin = joint.offset.translation();
        if (joint.kind == SpatialJoint::Kind::Prismatic)
        {
            frame.linear() = rotations_[i].fixed;
            origin += q[i] * (rotations_[i].fixed * joint.axis);
        }
        else
        {
            const double cosine = std::cos(q[i]);
            const double sine = std::sin(q[i]);
            frame.linear() = rotations_[i].fixed + sine * rotations_[i].sine + (1.0 - cosine) * rotations_[i].cosine;
        }
        frame.translation() = origin;
        frame.makeAffine();
        if (joint.parent >= 0)
        {
            const Isometry3d &parent = placement.frames[joint.parent];
            frame.translation() = parent.linear() * origin + parent.translation();
            frame.linear() = (parent.linear() * frame.linear()).eval();
        }
    }
    for (std::size_t i = 0; i < links_.size(); ++i)
    {
        const SpatialLink &link = links_[i];
        placement.points[2 * i] = link.joint < 0 ? link.from : placement.frames[link.joint] * link.from;
        placement.points[2 * i + 1] = link.joint < 0 ? link.to : placement.frames[link.joint] * link.to;
    }
}

void SpatialArm::motionBounds(const Eigen::Ref<const Eigen::VectorXd> &delta, Eigen::VectorXd &lengths,
                              Eigen::VectorXd &bends, Eigen::VectorXd &turns) const
{
    thread_local std::vector<JointBounds> bounds;
    bounds.resize(joints_.size());
    // A vector that a joint's frame carries. The joint's own turn moves it by its distance from the axis only; of two
    // derivatives of a product of rotations, every pair of joints contributes the product of their rates.
    const auto carried = [&](int joint, const Lever &vector)
    {
        JointBounds there = bounds[joint];
        const double own = joints_[joint].kind == SpatialJoint::Kind::Revolute ? std::abs(delta[joint]) : 0.0;
        const double others = there.turn - own;
        there.way += others * vector.length + own * vector.perpendicular;
        there.bend += others * others * vector.length + (2.0 * others + own) * own * vector.perpendicular;
        return there;
    };
    for (int i = 0; i < dimension(); ++i)
    {
        bounds[i] = joints_[i].parent < 0 ? JointBounds() : carried(joints_[i].parent, hops_[i]);
        if (joints_[i].kind == SpatialJoint::Kind::Prismatic)
            bounds[i].slide += delta[i] * directions_[i];
        else
            bounds[i].turn += std::abs(delta[i]);
    }
    lengths.resize(linkCount());
    bends.resize(linkCount());
    turns.resize(linkCount());
    for (int i = 0; i < linkCount(); ++i)
    {
        const JointBounds link = links_[i].joint < 0 ? JointBounds() : carried(links_[i].joint, extents_[i]);
        lengths[i] = link.way + link.slide.norm();
        bends[i] = link.bend;
        turns[i] = link.turn;
    }
}

void SpatialArm::velocities(const Placement &placement, const Eigen::Ref<const Eigen::VectorXd> &delta,
                            std::vector<Vector3d> &points, std::vector<Vector3d> &spins) const
{
    thread_local std::vector<JointVelocity> velocities;
    velocities.resize(joints_.size());
    const auto carried = [&](int joint, const Vector3d &point)
    {
        const JointVelocity &frame = velocities[joint];
        return Vector3d(frame.linear + frame.angular.cross(point - placement.frames[joint].translation()));
    };
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
        const int parent = joints_[i].parent;
        JointVelocity velocity;
        if (parent >= 0)
            velocity = {carried(parent, placement.frames[i].translation()), velocities[parent].angular};
        if (joints_[i].kind == SpatialJoint::Kind::Prismatic)
            velocity.linear += delta[i] * directions_[i];
        else
            velocity.angular += delta[i] * (placement.frames[i].linear() * joints_[i].axis);
        velocities[i] = velocity;
    }
    points.assign(2 * links_.size(), Vector3d::Zero());
    spins.assign(links_.size(), Vector3d::Zero());
    for (std::size_t i = 0; i < links_.size(); ++i)
        if (links_[i].joint >= 0)
        {
            points[2 * i] = carried(links_[i].joint, placement.points[2 * i]);
            points[2 * i + 1] = carried(links_[i].joint, placement.points[2 * i + 1]);
            spins[i] = velocities[links_[i].joint].angular;
        }
}
}  // namespace narrows
