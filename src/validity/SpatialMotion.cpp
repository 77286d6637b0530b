// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SpatialMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace narrows::proof
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// 0 for exact rotations and unit vectors; SpatialArm accepts some that are a little off.
double flawOf(const SpatialJoint &joint)
{
    const Matrix3d turn = joint.offset.linear();
    return (turn.transpose() * turn - Matrix3d::Identity()).cwiseAbs().maxCoeff() +
           std::abs(joint.axis.squaredNorm() - 1.0);
}
}  // namespace

SpatialMotion::SpatialMotion(const SpatialArm &arm)
  : arm_(arm),
    frames_(arm.joints().size()),
    rates_(arm.joints().size()),
    links_(arm.links().size()),
    flaw_(std::numeric_limits<double>::epsilon())
{
    for (const SpatialJoint &joint : arm.joints())
        flaw_ = std::max(flaw_, flawOf(joint));
    for (const SpatialLink &link : arm.links())
        levers_.push_back(leversOf(link));
}

/// What a joint carries first, up to the next joint, is fixed in its frame, so that only the part across its axis
/// counts; what comes after may point anywhere.
std::vector<SpatialMotion::Lever> SpatialMotion::leversOf(const SpatialLink &link) const
{
    std::vector<Lever> levers;
    double beyond = 0.0;  // furthest that the link gets from the origin of the joint looked at before
    std::vector<Vector3d> carried{link.from, link.to};
    for (int index = link.joint; index >= 0; index = arm_.joints()[index].parent)
    {
        const SpatialJoint &joint = arm_.joints()[index];
        double across = 0.0, length = 0.0;
        for (const Vector3d &vector : carried)
        {
            across = std::max(across, joint.axis.cross(vector).norm());
            length = std::max(length, vector.norm());
        }
        const bool turns = joint.kind == SpatialJoint::Kind::Revolute;
        levers.push_back({index, turns, turns ? across + beyond : 1.0});
        beyond += length;
        carried = {joint.offset.translation()};
    }
    std::reverse(levers.begin(), levers.end());
    return levers;
}

void SpatialMotion::place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t)
{
    for (int i = 0; i < arm_.dimension(); ++i)
    {
        const SpatialJoint &joint = arm_.joints()[i];
        const Frame &carrier = frameOf(joint.parent);
        const double rate = to[i] - from[i], value = from[i] + t * rate;
        Frame &frame = frames_[i];
        frame.turn = carrier.turn * joint.offset.linear();
        frame.origin = carrier.origin + carrier.turn * joint.offset.translation();
        frame.velocity = carrier.velocityAt(frame.origin);
        frame.spin = carrier.spin;
        const Vector3d axis = frame.turn * joint.axis;
        if (joint.kind == SpatialJoint::Kind::Prismatic)
        {
            frame.origin += value * axis;
            frame.velocity += rate * axis;  // no joint turns below a prismatic one, so that the axis is at rest
        }
        else
        {
            frame.turn = (frame.turn * Eigen::AngleAxisd(value, joint.axis).toRotationMatrix()).eval();
            frame.spin += rate * axis;
        }
        rates_[i] = rate;
    }
    for (int i = 0; i < arm_.linkCount(); ++i)
        links_[i] = linkIn(-1, i);
}

/// How a link moves in the frame of the joint `carrier`, which carries it, or in the world (-1). The derivative of a
/// point by one joint is at most that joint's lever, and by two joints at most the later one's: its vector only turns
/// with the earlier.
MovingSegment<3> SpatialMotion::linkIn(int carrier, int link) const
{
    const SpatialLink &shape = arm_.links()[link];
    const Frame &frame = frameOf(shape.joint), &reference = frameOf(carrier);
    double travel = 0.0, bend = 0.0;
    double turning = 0.0;  // sum of the rates of earlier joints
    for (const Lever &lever : levers_[link])
    {
        if (lever.joint <= carrier)
            continue;
        const double rate = std::abs(rates_[lever.joint]);
        travel += rate * lever.arm;
        if (!lever.turns)
            continue;
        bend += rate * (rate + 2.0 * turning) * lever.arm;
        turning += rate;
    }
    const auto moving = [&](const Vector3d &point)
    {
        const Vector3d position = frame.origin + frame.turn * point;
        return MovingPoint<3>{position, frame.velocityAt(position) - reference.velocityAt(position), travel, bend};
    };
    return {moving(shape.from), moving(shape.to)};
}

MovingPair<3> SpatialMotion::between(int first, int second) const
{
    int one = arm_.links()[first].joint, other = arm_.links()[second].joint;
    while (one != other)  // the later joint cannot carry the earlier one
    {
        int &later = one > other ? one : other;
        later = arm_.joints()[later].parent;
    }
    return {linkIn(one, first), linkIn(one, second)};
}

/// As in the plane, a value is as rough as it is large.
double SpatialMotion::extent(const std::vector<Eigen::VectorXd> &path) const
{
    double largestValue = 1.0;
    for (const Eigen::VectorXd &row : path)
        largestValue = std::max(largestValue, row.cwiseAbs().maxCoeff());
    double offsets = 0.0, slides = 0.0, ends = 0.0;
    for (const SpatialJoint &joint : arm_.joints())
    {
        offsets += joint.offset.translation().norm();
        slides += joint.kind == SpatialJoint::Kind::Prismatic ? 1.0 : 0.0;
    }
    for (const SpatialLink &link : arm_.links())
        ends = std::max({ends, link.from.norm(), link.to.norm()});
    return (offsets + slides + ends) * largestValue;
}

double SpatialMotion::rounding(double extent) const
{
    return (64 + 16 * arm_.dimension()) * flaw_ * extent;
}
}  // namespace narrows::proof
