// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/EdgedPole.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
using Eigen::Vector3d;

EdgedPole::EdgedPole(const Box &box) : solid_(box)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double second : {-1.0, 1.0})
            for (const double third : {-1.0, 1.0})
            {
                Vector3d from, to;
                from[axis] = -1.0;
                to[axis] = 1.0;
                from[(axis + 1) % 3] = to[(axis + 1) % 3] = second;
                from[(axis + 2) % 3] = to[(axis + 2) % 3] = third;
                edges_.emplace_back(box.pose * Vector3d(from.cwiseProduct(box.halfExtents)),
                                    box.pose * Vector3d(to.cwiseProduct(box.halfExtents)));
            }
}

EdgedPole::EdgedPole(const Prism &prism, double far) : solid_(prism)
{
    const std::size_t count = prism.vertices.size();
    const bool hasEnds = std::isfinite(prism.halfLength);
    const auto corner = [&](std::size_t i, double height)
    {
        const Eigen::Vector2d &vertex = prism.vertices[i % count];
        return Vector3d(prism.pose * Vector3d(vertex.x(), vertex.y(), height));
    };
    const double nearOrigin = hasEnds ? 0.0 : -prism.axis().dot(prism.pose.translation());
    const double half = hasEnds ? prism.halfLength : far;
    for (std::size_t i = 0; i < count; ++i)
    {
        edges_.emplace_back(corner(i, nearOrigin - half), corner(i, nearOrigin + half));
        for (const double end : {-half, half})
            if (hasEnds)
                edges_.emplace_back(corner(i, end), corner(i + 1, end));
    }
}

Nearness EdgedPole::nearest(const Vector3d &a, const Vector3d &b) const
{
    return std::visit([&](const auto &solid) { return nearness(a, b, solid); }, solid_);
}

SpatialTerm EdgedPole::clearance(const Vector3d &a, const Vector3d &b, double linkRadius) const
{
    const SpatialTerm exact = clearanceOf(nearest(a, b), linkRadius);
    if (exact.value <= 0.0)
        return exact;
    double sum = 0.0;
    EndForces pull;
    const auto add = [&](double fraction, const Vector3d &apart)
    {
        const double inverse = 1.0 / (apart.squaredNorm() - linkRadius * linkRadius);
        sum += inverse * inverse;
        pull.push(fraction, inverse * inverse * inverse * apart);
    };
    const Nearness atA = nearest(a, a), atB = nearest(b, b);
    add(0.0, atA.distance * atA.normal);
    add(1.0, atB.distance * atB.normal);
    for (const auto &[from, to] : edges_)
    {
        const ClosestFractions closest = closestFractions(a, b, from, to);
        add(closest.first, a + closest.first * (b - a) - from - closest.second * (to - from));
    }
    // With E = e (e + 2 radius): dE = E^3 sum of F_k^-3 dF_k and dE = 2 (e + radius) de, where dF_k = 2 apart .
    // d(apart).
    const double excess = 1.0 / std::sqrt(sum);
    const double root = std::sqrt(excess + linkRadius * linkRadius);
    SpatialTerm term{excess / (root + linkRadius), {}};
    term.slope.add(excess * excess * excess / root, pull);
    return term;
}
}  // namespace narrows
