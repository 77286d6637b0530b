// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/LinkMotion.h"

namespace narrows
{
/// The direction of an edge that a link passes: of any length, which is constant, at rest or turning.
struct MovingEdge
{
    Eigen::Vector3d along;
    Eigen::Vector3d rate;  ///< its derivative in the middle of the stretch
    double turn;           ///< bound on its angular speed, as in LinkMotion
};

inline MovingEdge resting(const Eigen::Vector3d &along)
{
    return {along, Eigen::Vector3d::Zero(), 0.0};
}

/// Whether a point stays further than `contact` from the plane that contains the link and is parallel to an edge, on
/// the side where it is, all along a stretch.
///
/// With D and E along the link and the edge, N = D x E, and w from the point to a point of the link, the distance is
/// N . w / |N|. Bounded are the derivatives of G = N . w - contact |N|, for |N| also from above:
///   |N + t N' + t^2 N'' / 2| <= |N| + t s + t^2 / 2 (p^2 / (|N| - h |s|) + sup |N''|),  t in [-h, h],
/// where s and p are the parts of N' along and across N.
class CrossingMotion
{
public:
    /// \param fraction where on the link, in [0, 1]: next to the edge is best
    /// \param normal from the obstacle towards the link; its side of the plane is meant
    CrossingMotion(const LinkMotion<3> &link, double fraction, const MovingEdge &edge, const Eigen::Vector3d &normal)
      : half_(link.half)
    {
        const Eigen::Vector3d along = link.b.position - link.a.position;
        const Eigen::Vector3d rate = link.b.velocity - link.a.velocity;
        normal_ = along.cross(edge.along);
        normalRate_ = rate.cross(edge.along) + along.cross(edge.rate);
        if (normal_.dot(normal) < 0.0)
        {
            normal_ = -normal_;
            normalRate_ = -normalRate_;
        }
        const double turn = link.turn + edge.turn;
        curvature_ = turn * turn * along.norm() * edge.along.norm();
        length_ = normal_.norm();
        speed_ = normalRate_.norm() + half_ * curvature_;
        stretching_ = length_ > 0.0 ? normal_.dot(normalRate_) / length_ : 0.0;
        position_ = link.a.position + fraction * along;
        velocity_ = link.a.velocity + fraction * rate;
        way_ = std::max(link.a.way, link.b.way);
        bend_ = std::max(link.a.bend, link.b.bend);
    }

    bool keepsAway(const MovingPoint<3> &point, double contact) const
    {
        const double shortest = length_ - half_ * std::abs(stretching_);
        if (!(shortest > 0.0))
            return false;
        const Eigen::Vector3d apart = position_ - point.position;
        const Eigen::Vector3d rate = velocity_ - point.velocity;
        const double bends = bend_ + point.bend;
        const double speed = std::min(way_ + point.way, rate.norm() + half_ * bends);
        const double across = normalRate_.squaredNorm() - stretching_ * stretching_;
        const double value = normal_.dot(apart) - contact * length_;
        const double slope = normalRate_.dot(apart) + normal_.dot(rate) - contact * stretching_;
        const double curvature = curvature_ * (apart.norm() + half_ * speed) + 2.0 * speed_ * speed +
                                 (length_ + half_ * speed_) * bends +
                                 contact * (std::max(across, 0.0) / shortest + curvature_);
        return value - half_ * (std::abs(slope) + 0.5 * half_ * curvature) > 0.0;
    }

private:
    double half_;
    Eigen::Vector3d normal_, normalRate_;
    double length_;      // of the normal
    double stretching_;  // its derivative
    double speed_;       // bound on the normal's rate, all along the stretch
    double curvature_;   // bound on its second derivative
    Eigen::Vector3d position_, velocity_;
    double way_, bend_;
};
}  // namespace narrows
