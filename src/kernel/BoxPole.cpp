// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/BoxPole.h"

namespace narrows
{
using Eigen::Vector3d;

BoxPole::BoxPole(const Box &box) : box_(box)
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
                edges_.push_back({box.pose * Vector3d(from.cwiseProduct(box.halfExtents)),
                                  box.pose * Vector3d(to.cwiseProduct(box.halfExtents))});
            }
}

SpatialTerm BoxPole::clearance(const Vector3d &a, const Vector3d &b, double linkRadius) const
{
    const SpatialTerm exact = clearanceOf(nearness(a, b, box_), linkRadius);
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
    const Nearness atA = nearness(a, a, box_), atB = nearness(b, b, box_);
    add(0.0, atA.distance * atA.normal);
    add(1.0, atB.distance * atB.normal);
    for (const Edge &edge : edges_)
    {
        const ClosestFractions closest = closestFractions(a, b, edge.from, edge.to);
        add(closest.first, a + closest.first * (b - a) - edge.from - closest.second * (edge.to - edge.from));
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
