// SPDX-License-Identifier: BSD-3-Clause
#include "validity/JointRules.h"

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace narrows::proof
{
namespace
{
using boost::math::double_constants::pi;

bool isWithin(double value, double lower, double upper)
{
    return value >= lower - limitTolerance && value <= upper + limitTolerance;
}

double differenceOf(double value, double other, bool turnsFreely)
{
    return std::abs(turnsFreely ? std::remainder(value - other, 2.0 * pi) : value - other);
}
}  // namespace

bool PlanarRules::within(const Eigen::VectorXd &row) const
{
    if (const auto &slide = arm_.slide(); slide && !isWithin(row[0], slide->lower, slide->upper))
        return false;
    for (int link = 0; link < arm_.linkCount(); ++link)
        if (const std::optional<Interval> limit = limitOf(link))
            if (!isWithin(joint(row, link), limit->lower, limit->upper))
                return false;
    return true;
}

bool PlanarRules::same(const Eigen::VectorXd &row, const Eigen::VectorXd &other, double tolerance) const
{
    if (arm_.slide() && std::abs(row[0] - other[0]) > tolerance)
        return false;
    for (int link = 0; link < arm_.linkCount(); ++link)
        if (differenceOf(joint(row, link), joint(other, link), !limitOf(link)) > tolerance)
            return false;
    return true;
}

std::optional<Interval> PlanarRules::limitOf(int link) const
{
    return limits_.angles.empty() ? std::nullopt : limits_.angles[link];
}

double PlanarRules::joint(const Eigen::VectorXd &row, int link) const
{
    const int offset = arm_.slide() ? 1 : 0;
    const int parent = arm_.links()[link].parent;
    const bool relative = limits_.convention == AngleConvention::Relative && parent >= 0;
    return row[offset + link] - (relative ? row[offset + parent] : 0.0);
}

SpatialRules::SpatialRules(const SpatialArm &arm) : arm_(arm)
{
    for (const SpatialJoint &joint : arm.joints())
        turnsFreely_.push_back(joint.kind == SpatialJoint::Kind::Revolute && !joint.limits);
    for (const UniversalLimit &limit : arm.universalLimits())
        turnsFreely_[limit.first] = turnsFreely_[limit.second] = false;
}

/// A universal joint's permitted pairs are convex because -log cos is, between -pi / 2 and pi / 2. There are more such
/// sets, full turns away; only the one around 0 is meant.
bool SpatialRules::within(const Eigen::VectorXd &row) const
{
    for (int i = 0; i < arm_.dimension(); ++i)
        if (const auto &limit = arm_.joints()[i].limits; limit && !isWithin(row[i], limit->lower, limit->upper))
            return false;
    for (const UniversalLimit &limit : arm_.universalLimits())
    {
        const double first = row[limit.first], second = row[limit.second];
        const double bend = std::acos(std::cos(first) * std::cos(second));
        for (const double angle : {first, second, bend})
            if (!isWithin(angle, -limit.maxAngle, limit.maxAngle))
                return false;
    }
    return true;
}

bool SpatialRules::same(const Eigen::VectorXd &row, const Eigen::VectorXd &other, double tolerance) const
{
    for (int i = 0; i < arm_.dimension(); ++i)
        if (differenceOf(row[i], other[i], turnsFreely_[i]) > tolerance)
            return false;
    return true;
}
}  // namespace narrows::proof
