// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmMotion.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
ArmMotion::ArmMotion(const PlanarArm &arm) : arm_(arm), points_(arm.links().size() + 1)
{
}

void ArmMotion::place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t)
{
    points_[0] = {arm_.base(), Eigen::Vector2d::Zero(), 0.0, 0.0};
    int value = 0;
    if (const auto &slide = arm_.slide())
    {
        const double rate = to[value] - from[value];
        points_[0].position += (from[value] + t * rate) * slide->axis;
        points_[0].velocity = rate * slide->axis;
        points_[0].travel = std::abs(rate);
        ++value;
    }
    for (int link = 0; link < arm_.linkCount(); ++link, ++value)
    {
        const double length = arm_.links()[link].length;
        const double rate = to[value] - from[value];
        const double angle = from[value] + t * rate;
        const Eigen::Vector2d arm = length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        const MovingPoint &carrier = points_[baseOf(link)];
        points_[tipOf(link)] = {carrier.position + arm, carrier.velocity + rate * Eigen::Vector2d(-arm.y(), arm.x()),
                                carrier.travel + length * std::abs(rate), carrier.bend + length * rate * rate};
    }
}

double ArmMotion::travelAlong(int index, const Eigen::Vector2d &u, double half) const
{
    const MovingPoint &point = points_[index];
    return std::min(point.travel * half, std::abs(point.velocity.dot(u)) * half + 0.5 * point.bend * half * half);
}
}  // namespace narrows
