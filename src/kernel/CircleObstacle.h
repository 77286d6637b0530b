// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernel/LinkObstacle.h"

namespace narrows
{
/// Inline where speed counts: most scenes are made of circles.
class CircleObstacle final : public LinkObstacle
{
public:
    /// \param linkRadius half-width of the links, >= 0
    CircleObstacle(const Circle &circle, double linkRadius)
      : center_(circle.center), radius_(circle.radius + linkRadius), squaredRadius_(radius_ * radius_)
    {
    }

    /// |p - c|^2 - r^2 at the link's point nearest to the center.
    LinkTerm pole(const Segment &link) const override
    {
        const double fraction = link.nearest(center_);
        const Eigen::Vector2d apart = link.at(fraction) - center_;
        return {apart.squaredNorm() - squaredRadius_, LinkForce::at(fraction, 2.0 * apart)};
    }

    /// Adds P / C to `sum` and its derivative to `force`; returns C. Spelled out by coordinates, which halves its time.
    double addPole(const Segment &link, double strength, double &sum, LinkForce &force) const
    {
        const double x = link.base.x() - center_.x();
        const double y = link.base.y() - center_.y();
        const double foot = -(x * link.along.x() + y * link.along.y()) * link.inverseSquare;
        const double fraction = std::min(std::max(foot, 0.0), 1.0);
        const double apartX = x + fraction * link.along.x();
        const double apartY = y + fraction * link.along.y();
        const double pole = apartX * apartX + apartY * apartY - squaredRadius_;
        const double inverse = 1.0 / pole;
        const double share = strength * inverse;
        const double slope = -2.0 * share * inverse;
        const double lever = slope * fraction;
        sum += share;
        force.force.x() += slope * apartX;
        force.force.y() += slope * apartY;
        force.lever.x() += lever * apartX;
        force.lever.y() += lever * apartY;
        return pole;
    }

    LinkTerm clearance(const Segment &link) const override
    {
        const double fraction = link.nearest(center_);
        const Eigen::Vector2d apart = link.at(fraction) - center_;
        const double distance = apart.norm();
        const Eigen::Vector2d normal = distance > 0.0 ? Eigen::Vector2d(apart / distance) : link.normal();
        return {distance - radius_, LinkForce::at(fraction, normal)};
    }

private:
    Eigen::Vector2d center_;
    double radius_;  ///< grown by the link's
    double squaredRadius_;
};
}  // namespace narrows
