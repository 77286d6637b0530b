// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/MeshGeometry.h"
#include "validity/FclSolid.h"
#include "validity/LinkChecker.h"

namespace narrows
{
/// An obstacle, or a part of one.
struct FclObstacle
{
    FclSolid solid;
    std::optional<MeshGeometry> mesh;  ///< what FCL does not know of its meshes: what is inside

    bool contains(const Eigen::Vector3d &point) const { return mesh && mesh->contains(point); }
};

/// Asks FCL about links in space, or in the plane z = 0. Motions are examined to first order only: a library that
/// answers yes or no has no line or plane to show.
template <int Dim>
class FclLinkChecker final : public LinkChecker<Dim>
{
public:
    explicit FclLinkChecker(std::vector<FclObstacle> obstacles) : obstacles_(std::move(obstacles)) {}

    bool clears(const Link<Dim> &link, ObstacleBits /*near*/) const override
    {
        const FclSegment segment(lift(link.a), lift(link.b));
        return std::all_of(obstacles_.begin(), obstacles_.end(),
                           [&](const FclObstacle &obstacle)
                           { return examine(segment, obstacle, link.radius, 0.0) == Finding::Clear; });
    }

    double clearance(const Link<Dim> &link) const override
    {
        const FclSegment segment(lift(link.a), lift(link.b));
        constexpr double far = std::numeric_limits<double>::infinity();
        double least = far;
        for (const FclObstacle &obstacle : obstacles_)
        {
            if (obstacle.contains(segment.end()))
                return 0.0;
            if (segment.boxDistance(obstacle.solid) - link.radius < least &&
                !(least < far && segment.clears(obstacle.solid, link.radius + least)))
                least = std::min(least, segment.clearance(obstacle.solid, link.radius));
        }
        return least;
    }

    Finding examine(const LinkMotion<Dim> &link, ObstacleBits /*near*/) const override
    {
        const FclSegment segment(lift(link.a.position), lift(link.b.position));
        const double reach = link.reach();
        Finding worst = Finding::Clear;
        for (const FclObstacle &obstacle : obstacles_)
        {
            worst = std::max(worst, examine(segment, obstacle, link.radius, reach));
            if (worst == Finding::Touching)
                break;
        }
        return worst;
    }

    bool clears(const Link<Dim> &link, const Link<Dim> &other) const override
    {
        return FclSegment(lift(link.a), lift(link.b)).clears(capsule(other), link.radius);
    }

    double clearance(const Link<Dim> &link, const Link<Dim> &other) const override
    {
        return FclSegment(lift(link.a), lift(link.b)).clearance(capsule(other), link.radius);
    }

    Finding examine(const LinkMotion<Dim> &link, const LinkMotion<Dim> &other) const override
    {
        const FclObstacle obstacle{capsule({other.a.position, other.b.position, other.radius}), {}};
        return examine(FclSegment(lift(link.a.position), lift(link.b.position)), obstacle, link.radius,
                       link.reach() + other.reach());
    }

private:
    static Eigen::Vector3d lift(const Eigen::Vector2d &point) { return {point.x(), point.y(), 0.0}; }
    static Eigen::Vector3d lift(const Eigen::Vector3d &point) { return point; }

    static FclSolid capsule(const Link<Dim> &link) { return fclCapsule(lift(link.a), lift(link.b), link.radius); }

    static Finding examine(const FclSegment &segment, const FclObstacle &obstacle, double radius, double reach)
    {
        if (segment.boxDistance(obstacle.solid) > radius + reach)
            return Finding::Clear;
        if (obstacle.contains(segment.end()))
            return Finding::Touching;
        if (segment.clears(obstacle.solid, radius + reach))
            return Finding::Clear;
        return reach > 0.0 && segment.clears(obstacle.solid, radius) ? Finding::Unsure : Finding::Touching;
    }

    std::vector<FclObstacle> obstacles_;
};
}  // namespace narrows
