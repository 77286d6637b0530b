// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SupportDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr int maxSteps = 100;  // the fourfold shrinking gap is below rounding after about 25

double cross(const Vector2d &a, const Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Vector2d furthestOf(const std::vector<Vector2d> &points, const Vector2d &u)
{
    Vector2d furthest = points.front();
    double value = furthest.dot(u);
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const double other = points[i].dot(u); other > value)
        {
            value = other;
            furthest = points[i];
        }
    return furthest;
}

/// Where the gradient of |x/a|^p + |y/b|^p is parallel to u. Scaled by the larger component first, so that high
/// exponents neither overflow nor vanish.
Vector2d furthestOf(const Superellipse &shape, const Vector2d &u)
{
    const Vector2d scaled = shape.halfExtents.cwiseProduct(u);
    const Vector2d size = scaled.cwiseAbs();
    const double root = 1.0 / (shape.exponent - 1.0);
    const double ratio = std::pow(size.minCoeff() / size.maxCoeff(), root);
    const double scale = std::pow(1.0 + std::pow(ratio, shape.exponent), -1.0 / shape.exponent);
    const bool wide = size.x() >= size.y();
    const Vector2d unit(std::copysign(wide ? scale : ratio * scale, scaled.x()),
                        std::copysign(wide ? ratio * scale : scale, scaled.y()));
    return shape.center + shape.halfExtents.cwiseProduct(unit);
}

/// One or two points of the set {segment point - core point}, and the point between them nearest to the origin.
struct Simplex
{
    Vector2d first;
    std::optional<Vector2d> second;
    Vector2d nearest;

    /// Unit vector from the origin to `nearest`. Across a segment it is the normal: near contact `nearest` is a
    /// difference of almost equal numbers, the normal is not.
    Vector2d direction() const
    {
        if (!second)
            return nearest.normalized();
        const Vector2d along = *second - first;
        const Vector2d normal = Vector2d(-along.y(), along.x()).normalized();
        return normal.dot(first) >= 0.0 ? normal : Vector2d(-normal);
    }
};

Simplex nearestBetween(const Vector2d &a, const Vector2d &b)
{
    const Vector2d along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? -a.dot(along) / squared : 0.0;
    if (t <= 0.0)
        return {a, std::nullopt, a};
    if (t >= 1.0)
        return {b, std::nullopt, b};
    return {a, b, a + t * along};
}

bool originInTriangle(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
}

/// The best simplex within the old one and a new point; nothing if they enclose the origin.
std::optional<Simplex> extend(const Simplex &old, const Vector2d &added)
{
    const Simplex one = nearestBetween(old.first, added);
    if (!old.second)
        return one;
    if (originInTriangle(old.first, *old.second, added))
        return std::nullopt;
    const Simplex other = nearestBetween(*old.second, added);
    return one.nearest.squaredNorm() <= other.nearest.squaredNorm() ? one : other;
}

bool reached(const SeparationGoal &goal, const Separation &found)
{
    const double gap = found.upper - found.lower;
    const double usefulGap = std::min(goal.absoluteGap, goal.relativeGap * (found.upper - goal.thickness));
    return found.upper <= goal.thickness || found.lower >= goal.enough || gap <= std::max(goal.rounding, usefulGap);
}
}  // namespace

Vector2d supportPoint(const ConvexSet &set, const Vector2d &u)
{
    return std::visit([&u](const auto &core) { return furthestOf(core, u); }, set.core);
}

double separationAlong(const ConvexSet &set, const Vector2d &a, const Vector2d &b, const Vector2d &u)
{
    const Vector2d point = supportPoint(set, u);
    return std::min((a - point).dot(u), (b - point).dot(u));
}

Separation separate(const ConvexSet &set, const Vector2d &a, const Vector2d &b, const Vector2d &guess,
                    const SeparationGoal &goal)
{
    Separation best{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), guess};
    std::optional<Simplex> simplex;
    Vector2d u = guess;
    for (int step = 0; step < maxSteps; ++step)
    {
        const Vector2d point = supportPoint(set, u);
        const Vector2d fromA = a - point, fromB = b - point;
        const Vector2d &extreme = fromA.dot(u) <= fromB.dot(u) ? fromA : fromB;
        if (extreme.dot(u) > best.lower)
        {
            best.lower = extreme.dot(u);
            best.direction = u;
        }
        simplex = simplex ? extend(*simplex, extreme) : Simplex{extreme, std::nullopt, extreme};
        best.upper = simplex ? std::min(best.upper, simplex->nearest.norm()) : 0.0;
        if (reached(goal, best))
            break;
        u = simplex->direction();
    }
    return best;
}
}  // namespace narrows
