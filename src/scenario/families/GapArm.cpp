// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/GapArm.h"

#include <cmath>

#include "scenario/families/ArmScene.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

Vector2d unitVector(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// Angles of two links of lengths a and b from the origin to a point, their joint to one side of the straight line; not
/// finite if the point is out of reach.
Vector2d reachPoint(double a, double b, const Vector2d &point, int side)
{
    const double square = point.squaredNorm();
    const double direction = std::atan2(point.y(), point.x());
    const double first = std::acos((square + a * a - b * b) / (2.0 * a * std::sqrt(square)));
    const double second = std::acos((square + b * b - a * a) / (2.0 * b * std::sqrt(square)));
    return {direction + side * first, direction - side * second};
}

/// The angle that differs from `near` by at most half a turn.
double unwound(double angle, double near)
{
    return near + std::remainder(angle - near, 2.0 * M_PI);
}
}  // namespace

GapArm::GapArm(const std::vector<double> &rods, int links) : lengths_(cut(rods, links))
{
    auto link = lengths_.begin();
    for (int i = 0; i < static_cast<int>(rods.size()); ++i)
    {
        const int count = share(i, static_cast<int>(rods.size()), links);
        rods_.push_back(count * *link);
        link += count;
        carrierLinks_ += i < carriers ? count : 0;
    }
}

bool GapArm::place(double direction, const Vector2d &begin, int side)
{
    direction_ = rounded(direction, 6);
    side_ = side;
    const Vector2d angles = reachPoint(rod(0), rod(1), begin, side);
    // Rounded alike on both sides, so that a line through the base stays one.
    angles_ = {rounded(direction_ + rounded(angles[0], 6), 6), rounded(direction_ + rounded(angles[1], 6), 6)};
    begin_ = rod(0) * unitVector(angles_[0]) + rod(1) * unitVector(angles_[1]);
    return begin_.allFinite();
}

Vector2d GapArm::along() const
{
    return unitVector(direction_);
}

Eigen::VectorXd GapArm::drawnBack(double way) const
{
    const Vector2d angles = reachPoint(rod(0), rod(1), begin_ - way * along(), side_);
    return configuration({unwound(angles[0], angles_[0]), unwound(angles[1], angles_[1])});
}

Eigen::VectorXd GapArm::configuration(const Vector2d &carrierAngles) const
{
    const int links = static_cast<int>(lengths_.size());
    Eigen::VectorXd q = Eigen::VectorXd::Constant(links, direction_);
    q.head(carrierLinks_).setConstant(carrierAngles[1]);
    q.head(share(0, rodCount(), links)).setConstant(carrierAngles[0]);
    return q;
}
}  // namespace narrows
