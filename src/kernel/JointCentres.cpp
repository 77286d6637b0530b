// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/JointCentres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace narrows
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

bool isTurn(const SpatialJoint &joint, int parent, const Vector3d &offset, const Vector3d &axis)
{
    return joint.kind == SpatialJoint::Kind::Revolute && joint.parent == parent &&
           joint.offset.linear() == Matrix3d::Identity() && joint.offset.translation() == offset && joint.axis == axis;
}

/// Is link i carried by joints 2 i + 1 and 2 i + 2, pitch and yaw, where the link before ends?
bool isUniversalLink(const SpatialArm &arm, int i)
{
    const int pitch = 2 * i + 1;
    const Vector3d offset = i == 0 ? Vector3d(Vector3d::Zero()) : arm.links()[i - 1].to;
    const SpatialLink &link = arm.links()[i];
    return isTurn(arm.joints()[pitch], pitch - 1, offset, Vector3d::UnitY()) &&
           isTurn(arm.joints()[pitch + 1], pitch, Vector3d::Zero(), Vector3d::UnitZ()) && link.joint == pitch + 1 &&
           link.from == Vector3d::Zero() && link.to == Vector3d(link.to.x(), 0.0, 0.0) && link.to.x() > 0.0 &&
           link.radius == arm.links()[0].radius;
}

bool isUniversalChain(const SpatialArm &arm)
{
    if (arm.linkCount() == 0 || arm.dimension() != 2 * arm.linkCount() + 1)
        return false;
    const SpatialJoint &slide = arm.joints()[0];
    if (slide.kind != SpatialJoint::Kind::Prismatic || slide.offset.linear() != Matrix3d::Identity())
        return false;
    for (int i = 0; i < arm.linkCount(); ++i)
        if (!isUniversalLink(arm, i))
            return false;
    return true;
}

bool sameLimits(const std::optional<Interval> &limits, const std::optional<Interval> &other)
{
    return limits.has_value() == other.has_value() &&
           (!limits || (limits->lower == other->lower && limits->upper == other->upper));
}

/// The largest bend if all universal joints share it and are limited by nothing else; infinity if nothing limits them.
std::optional<double> commonMaxAngle(const SpatialArm &arm)
{
    const std::vector<UniversalLimit> &limits = arm.universalLimits();
    std::optional<Interval> angles;
    if (!limits.empty())
        angles = Interval{-limits[0].maxAngle, limits[0].maxAngle};
    if (angles && static_cast<int>(limits.size()) != arm.linkCount())
        return std::nullopt;
    for (std::size_t i = 0; i < limits.size(); ++i)
        if (limits[i].first != static_cast<int>(2 * i + 1) || limits[i].second != limits[i].first + 1 ||
            limits[i].maxAngle != limits[0].maxAngle)
            return std::nullopt;
    for (int j = 1; j < arm.dimension(); ++j)
        if (!sameLimits(arm.joints()[j].limits, angles))
            return std::nullopt;
    return angles ? angles->upper : std::numeric_limits<double>::infinity();
}

double totalLength(const ChainGeometry &chain)
{
    return std::accumulate(chain.lengths.begin(), chain.lengths.end(), 0.0);
}

bool fits(const ChainGeometry &chain, const std::vector<Vector3d> &centres)
{
    if (centres.size() != chain.lengths.size() + 1)
        return false;
    const double tolerance = 1e-9 * totalLength(chain);
    const Vector3d offset = centres[0] - chain.origin;
    const double along = offset.dot(chain.axes.col(0));
    // Written so that NaN does not fit.
    if (!std::isfinite(along) || !((offset - along * chain.axes.col(0)).norm() <= tolerance))
        return false;
    for (std::size_t i = 0; i < chain.lengths.size(); ++i)
        if (!(std::abs((centres[i + 1] - centres[i]).norm() - chain.lengths[i]) <= tolerance))
            return false;
    return true;
}
}  // namespace

std::optional<ChainGeometry> chainGeometry(const SpatialArm &arm)
{
    if (!isUniversalChain(arm))
        return std::nullopt;
    const std::optional<double> maxAngle = commonMaxAngle(arm);
    if (!maxAngle)
        return std::nullopt;
    const SpatialJoint &slide = arm.joints()[0];
    ChainGeometry chain;
    chain.origin = slide.offset.translation();
    chain.axes = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), slide.axis).toRotationMatrix();
    chain.axes.col(0) = slide.axis;  // exactly
    for (const SpatialLink &link : arm.links())
        chain.lengths.push_back(link.to.x());
    chain.radius = arm.links()[0].radius;
    chain.maxAngle = *maxAngle;
    chain.slide = *slide.limits;
    return chain;
}

void jointCentres(const SpatialArm &arm, ConfigurationRef q, std::vector<Vector3d> &centres)
{
    thread_local SpatialArm::Placement placement;
    arm.place(q, placement);
    centres.resize(static_cast<std::size_t>(arm.linkCount()) + 1);
    centres[0] = placement.points[0];
    for (std::size_t i = 1; i < centres.size(); ++i)
        centres[i] = placement.points[2 * i - 1];
}

bool valuesFromCentres(const ChainGeometry &chain, const std::vector<Vector3d> &centres, Eigen::VectorXd &values)
{
    if (!fits(chain, centres))
        return false;
    values.resize(static_cast<Eigen::Index>(2 * chain.lengths.size() + 1));
    values[0] = (centres[0] - chain.origin).dot(chain.axes.col(0));
    Matrix3d frame = Matrix3d::Identity();
    for (std::size_t i = 0; i < chain.lengths.size(); ++i)
    {
        // In the frame of the link before, a link's direction is (cos pitch cos yaw, sin yaw, -sin pitch cos yaw).
        const Vector3d direction = (centres[i + 1] - centres[i]).normalized();
        const Vector3d local = frame.transpose() * direction;
        const double cosYaw = std::sqrt(local.x() * local.x() + local.z() * local.z());
        const double cosPitch = cosYaw > 0.0 ? local.x() / cosYaw : 1.0;
        const double sinPitch = cosYaw > 0.0 ? -local.z() / cosYaw : 0.0;
        values[static_cast<Eigen::Index>(2 * i + 1)] = std::atan2(sinPitch, cosPitch);
        values[static_cast<Eigen::Index>(2 * i + 2)] = std::atan2(local.y(), cosYaw);
        const Vector3d z = frame * Vector3d(sinPitch, 0.0, cosPitch);
        frame.col(0) = direction;
        frame.col(1) = z.cross(direction);
        frame.col(2) = z;
    }
    return true;
}

bool valuesFromCentres(const SpatialArm &arm, const std::vector<Vector3d> &centres, Eigen::VectorXd &values)
{
    const std::optional<ChainGeometry> chain = chainGeometry(arm);
    if (!chain)
        throw std::invalid_argument("only a chain of universal joints on a slide follows from its joint centres");
    return valuesFromCentres(*chain, centres, values);
}

double bendAngle(double pitch, double yaw)
{
    const double x = std::sin(0.5 * pitch) * std::sin(0.5 * pitch);
    const double y = std::sin(0.5 * yaw) * std::sin(0.5 * yaw);
    // sin^2(psi / 2), which keeps the digits of small angles
    return 2.0 * std::asin(std::sqrt(std::clamp(x + y - 2.0 * x * y, 0.0, 1.0)));
}
}  // namespace narrows
