// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialArm.h"

namespace narrows
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace
{
Isometry3d shift(const Vector3d &by)
{
    return Isometry3d(Eigen::Translation3d(by));
}
}  // namespace

SpatialArm universalChain(const Vector3d &base, const std::vector<double> &lengths, double radius,
                          const std::optional<std::pair<Vector3d, Interval>> &slide, std::optional<double> maxAngle)
{
    std::vector<SpatialJoint> joints;
    std::vector<SpatialLink> links;
    std::vector<UniversalLimit> limits;
    const auto add = [&](SpatialJoint::Kind kind, const Isometry3d &offset, const Vector3d &axis,
                         const std::optional<Interval> &interval)
    {
        joints.push_back({kind, static_cast<int>(joints.size()) - 1, offset, axis, interval});
    };

    Isometry3d offset = shift(base);
    if (slide)
    {
        add(SpatialJoint::Kind::Prismatic, offset, slide->first, slide->second);
        offset.setIdentity();
    }
    // No angle of a pair can be larger than the bend of both together.
    std::optional<Interval> interval;
    if (maxAngle)
        interval = Interval{-*maxAngle, *maxAngle};
    for (const double length : lengths)
    {
        add(SpatialJoint::Kind::Revolute, offset, Vector3d::UnitY(), interval);
        add(SpatialJoint::Kind::Revolute, Isometry3d::Identity(), Vector3d::UnitZ(), interval);
        const int yaw = static_cast<int>(joints.size()) - 1;
        links.push_back({yaw, Vector3d::Zero(), {length, 0.0, 0.0}, radius});
        if (maxAngle)
            limits.push_back({yaw - 1, yaw, *maxAngle});
        offset = shift({length, 0.0, 0.0});
    }
    return SpatialArm(std::move(joints), std::move(links), std::move(limits));
}

SpatialArm denavitHartenbergArm(const Isometry3d &base, const std::vector<DenavitHartenberg> &rows)
{
    std::vector<SpatialJoint> joints;
    std::vector<SpatialLink> links;
    Isometry3d offset = base;
    for (const DenavitHartenberg &row : rows)
    {
        const int joint = static_cast<int>(joints.size());
        const Vector3d corner(0.0, 0.0, row.d);
        const Vector3d end(row.a, 0.0, row.d);
        joints.push_back({SpatialJoint::Kind::Revolute, joint - 1,
                          offset * Eigen::AngleAxisd(row.theta, Vector3d::UnitZ()), Vector3d::UnitZ(), row.limits});
        if (row.d != 0.0)
            links.push_back({joint, Vector3d::Zero(), corner, row.radius});
        if (row.a != 0.0)
            links.push_back({joint, corner, end, row.radius});
        offset = shift(end) * Eigen::AngleAxisd(row.alpha, Vector3d::UnitX());
    }
    return SpatialArm(std::move(joints), std::move(links));
}
}  // namespace narrows
