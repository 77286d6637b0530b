// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "kernel/LinkObstacle.h"

namespace narrows
{
/// The obstacle function of a superellipse (PlanarRepulsionModel.h).
class SuperellipseObstacle : public LinkObstacle
{
public:
    /// \param linkRadius half-width of the links; \param reach upper bound of R
    SuperellipseObstacle(const Superellipse &shape, double linkRadius, double reach);

    LinkTerm pole(const Segment &link) const override;
    LinkTerm clearance(const Segment &link) const override;
    bool isMet(const Segment &link) const override;

private:
    LinkTerm outside(const Eigen::Vector2d &point, double fraction) const;
    LinkTerm gauge(const Segment &link, double &fraction) const;
    /// |x|^p + |y|^p somewhere on a segment, which is convex along it, and its derivatives by t over p.
    struct Level
    {
        double t, value, slope, bend;
    };
    Level level(const Eigen::Vector2d &from, const Eigen::Vector2d &along, double t) const;
    template <class IsEnough>
    double deepest(const Eigen::Vector2d &from, const Eigen::Vector2d &along, const IsEnough &isEnough) const;
    /// |x|^(p - 1) with the sign of x, for both entries, and, in `lower`, |x|^(p - 2).
    Eigen::Vector2d raise(const Eigen::Vector2d &base, Eigen::Vector2d &lower) const
    {
        if (quartic_)  // what the paper uses; pow() costs ten times as much
            lower = base.cwiseProduct(base);
        else
            lower = base.cwiseAbs().array().pow(exponent_ - 2.0);
        return lower.cwiseProduct(base);
    }
    /// power^(1 / p)
    double root(double power) const
    {
        return quartic_ ? std::sqrt(std::sqrt(power)) : std::pow(power, 1.0 / exponent_);
    }
    Eigen::Vector2d supportPoint(const Eigen::Vector2d &direction) const;
    double pointDistance(const Eigen::Vector2d &corner, Eigen::Vector2d &normal) const;

    Eigen::Vector2d center_, extents_, inverseExtents_;
    double exponent_;
    double leastExtent_;
    double linkRadius_;
    double size_;  ///< 2 (R + link radius)
    bool quartic_;
};
}  // namespace narrows
