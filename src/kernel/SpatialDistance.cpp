// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialDistance.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Nearness of a segment to all within `radius` of the point `core`, which is closest to it at `fraction`.
Nearness aroundPoint(const Vector3d &a, const Vector3d &b, double fraction, const Vector3d &core,
                     const Vector3d &coreDirection, double radius)
{
    Nearness nearest;
    nearest.fraction = fraction;
    nearest.point = a + fraction * (b - a);
    const Vector3d apart = nearest.point - core;
    const double distance = apart.norm();
    if (distance > 0.0)
        nearest.normal = apart / distance;
    else
    {
        const Vector3d across = (b - a).cross(coreDirection);
        nearest.normal = across.norm() > 0.0 ? across.normalized() : perpendicular(b - a);
    }
    nearest.distance = distance - radius;
    return nearest;
}

double closestFraction(const Vector3d &a, const Vector3d &b, const Vector3d &point)
{
    const Vector3d along = b - a;
    const double projection = along.dot(point - a);
    return projection > 0.0 ? std::min(projection / along.squaredNorm(), 1.0) : 0.0;
}

}  // namespace

Vector3d perpendicular(const Vector3d &direction)
{
    Eigen::Index least = 0;
    direction.cwiseAbs().minCoeff(&least);
    const Vector3d across = direction.cross(Vector3d::Unit(least));
    return across.norm() > 0.0 ? across.normalized() : Vector3d::UnitX();
}

ClosestFractions closestFractions(const Vector3d &a, const Vector3d &b, const Vector3d &c, const Vector3d &d)
{
    const Vector3d first = b - a, second = d - c, apart = a - c;
    const double firstSquare = first.squaredNorm(), secondSquare = second.squaredNorm();
    const double both = first.dot(second);
    const double f = first.dot(apart), g = second.dot(apart);
    const auto clamped = [](double numerator, double denominator)
    {
        return numerator > 0.0 ? std::min(numerator / denominator, 1.0) : 0.0;
    };

    // Where the lines come closest, moved into the first segment; then the best partner of that in the second, and the
    // best partner of that in the first: at the solution neither moves any more. Where the segments are all but
    // parallel the first guess means nothing, and a solution is at an end of one of them.
    const double determinant = firstSquare * secondSquare - both * both;
    ClosestFractions best{clamped(both * g - f * secondSquare, determinant), 0.0};
    best.second = clamped(both * best.first + g, secondSquare);
    best.first = clamped(both * best.second - f, firstSquare);
    if (determinant > 1e-4 * firstSquare * secondSquare)
        return best;

    double least = (apart + best.first * first - best.second * second).squaredNorm();
    const auto consider = [&](double s, double t)
    {
        const double square = (apart + s * first - t * second).squaredNorm();
        if (square < least)
        {
            least = square;
            best = {s, t};
        }
    };
    consider(0.0, clamped(g, secondSquare));
    consider(1.0, clamped(both + g, secondSquare));
    consider(clamped(-f, firstSquare), 0.0);
    consider(clamped(both - f, firstSquare), 1.0);
    return best;
}

Nearness nearness(const Vector3d &a, const Vector3d &b, const Sphere &sphere)
{
    return aroundPoint(a, b, closestFraction(a, b, sphere.center), sphere.center, Vector3d::Zero(), sphere.radius);
}

Nearness nearness(const Vector3d &a, const Vector3d &b, const Capsule &capsule)
{
    const Vector3d along = capsule.to - capsule.from;
    const ClosestFractions closest = closestFractions(a, b, capsule.from, capsule.to);
    return aroundPoint(a, b, closest.first, capsule.from + closest.second * along, along, capsule.radius);
}

}  // namespace narrows
