// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SuperellipseGeometry.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
using Eigen::Vector2d;

SuperellipseGeometry::SuperellipseGeometry(const Superellipse &shape)
  : center_(shape.center),
    halfExtents_(shape.halfExtents),
    exponent_(shape.exponent),
    dual_(shape.exponent / (shape.exponent - 1.0)),
    quartic_(shape.exponent == 4.0)
{
}

/// |base|^p; the paper's exponent 4 is worth a case of its own, pow() costs ten times as much.
double SuperellipseGeometry::power(double base) const
{
    if (quartic_)
    {
        const double square = base * base;
        return square * square;
    }
    return std::pow(std::abs(base), exponent_);
}

double SuperellipseGeometry::value(const Vector2d &point) const
{
    const Vector2d scaled = (point - center_).cwiseQuotient(halfExtents_);
    return power(scaled.x()) + power(scaled.y()) - 1.0;
}

double SuperellipseGeometry::slope(const Vector2d &point, const Vector2d &direction) const
{
    const Vector2d scaled = (point - center_).cwiseQuotient(halfExtents_);
    const Vector2d step = direction.cwiseQuotient(halfExtents_);
    if (quartic_)
        return 4.0 *
               (scaled.x() * scaled.x() * scaled.x() * step.x() + scaled.y() * scaled.y() * scaled.y() * step.y());
    const auto term = [this](double s, double d)
    {
        return exponent_ * std::copysign(std::pow(std::abs(s), exponent_ - 1.0), s) * d;
    };
    return term(scaled.x(), step.x()) + term(scaled.y(), step.y());
}

/// The point of the shape that lies furthest in the direction, relative to the center; `height` is its support value.
Vector2d SuperellipseGeometry::supportPoint(const Vector2d &direction, double &height) const
{
    const Vector2d scaled = direction.cwiseProduct(halfExtents_).cwiseAbs();
    const double largest = std::max(scaled.x(), scaled.y());
    if (!(largest > 0.0))
    {
        height = 0.0;
        return Vector2d::Zero();
    }
    // Scaled by the largest entry so that nothing under- or overflows.
    const Vector2d ratio = scaled / largest;
    Vector2d weight;  // ratio^(q - 1)
    double norm;      // |ratio|_q^(q - 1)
    if (quartic_)
    {
        weight = Vector2d(std::cbrt(ratio.x()), std::cbrt(ratio.y()));
        norm = std::sqrt(std::sqrt(weight.dot(ratio)));
    }
    else
    {
        weight = Vector2d(std::pow(ratio.x(), dual_ - 1.0), std::pow(ratio.y(), dual_ - 1.0));
        norm = std::pow(weight.dot(ratio), 1.0 - 1.0 / dual_);
    }
    const Vector2d corner = weight.cwiseProduct(halfExtents_) / norm;
    height = corner.dot(direction.cwiseAbs());
    return {std::copysign(corner.x(), direction.x()), std::copysign(corner.y(), direction.y())};
}

double SuperellipseGeometry::support(const Vector2d &direction) const
{
    double height;
    supportPoint(direction, height);
    return height;
}

bool SuperellipseGeometry::farther(const Vector2d &a, const Vector2d &b, double threshold) const
{
    const double tolerance = 1e-12 * halfExtents_.maxCoeff();
    return segmentDistance(a, b, threshold, tolerance).lower > threshold;
}

double SuperellipseGeometry::distance(const Vector2d &a, const Vector2d &b) const
{
    const double tolerance = 1e-12 * halfExtents_.maxCoeff();
    return segmentDistance(a, b, -1.0, tolerance).lower;
}

/// Bounds on the distance of segment and shape, as soon as they decide about a threshold (negative: never) or agree.
/// The distance to the points of a line is convex along it, so that the nearest point is where the line comes nearest
/// to the shape, or the end on that side.
SuperellipseGeometry::Bracket SuperellipseGeometry::segmentDistance(const Vector2d &a, const Vector2d &b,
                                                                    double threshold, double tolerance) const
{
    const Vector2d along = b - a;
    const double length = along.norm();
    if (!(length > 0.0))
        return pointDistance(a, threshold, tolerance);

    Vector2d normal(-along.y() / length, along.x() / length);
    const double offset = normal.dot(a - center_);
    if (offset < 0.0)
        normal = -normal;
    double height;
    const Vector2d nearest = supportPoint(normal, height);
    const double gap = std::abs(offset) - height;  // between the line and the shape
    if (gap > threshold && gap > 0.0 && threshold >= 0.0)
        return {gap, gap};

    const bool lineMisses = gap > 0.0;
    const double foot = along.dot(center_ + nearest - a) / (length * length);
    if (lineMisses && foot >= 0.0 && foot <= 1.0)
        return {gap, gap};
    if (lineMisses)
        return pointDistance(foot < 0.0 ? a : b, threshold, tolerance);
    // The line meets the shape. Where value() falls towards an end, the shape lies beyond it.
    if (value(a) <= 0.0 || value(b) <= 0.0)
        return {0.0, 0.0};
    if (slope(a, along) >= 0.0)
        return pointDistance(a, threshold, tolerance);
    if (slope(b, along) <= 0.0)
        return pointDistance(b, threshold, tolerance);
    return {0.0, 0.0};
}

/// Maximises the separation d . (point - center) - support(d) over unit directions d in the point's quadrant. Every d
/// gives a lower bound on the distance and every support point an upper one; the derivative over the angle is monotone.
SuperellipseGeometry::Bracket SuperellipseGeometry::pointDistance(const Vector2d &point, double threshold,
                                                                  double tolerance) const
{
    const Vector2d corner = (point - center_).cwiseAbs();
    const double outside = value(point);
    if (outside <= 0.0)
        return {0.0, 0.0};

    // First guess: the normal where the ray from the center leaves the shape.
    const Vector2d scaled = corner.cwiseQuotient(halfExtents_);
    const auto raised = [this](double s)
    {
        return quartic_ ? s * s * s : std::pow(s, exponent_ - 1.0);
    };
    double angle = std::atan2(raised(scaled.y()) / halfExtents_.y(), raised(scaled.x()) / halfExtents_.x());
    double low = 0.0;
    double high = std::acos(0.0);
    Bracket bracket{0.0, corner.norm()};
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        const Vector2d direction(std::cos(angle), std::sin(angle));
        double height;
        const Vector2d nearest = supportPoint(direction, height);
        const Vector2d apart = corner - nearest.cwiseAbs();
        bracket.lower = std::max(bracket.lower, direction.dot(corner) - height);
        bracket.upper = std::min(bracket.upper, apart.norm());
        const bool decided = threshold >= 0.0 && (bracket.lower > threshold || bracket.upper <= threshold);
        if (decided || bracket.upper - bracket.lower <= tolerance)
            break;
        const double turn = direction.x() * apart.y() - direction.y() * apart.x();
        (turn > 0.0 ? low : high) = angle;
        // The witness gives the next direction; where the shape is so flat that this does not shrink the bracket, halve
        // it.
        const double proposed = std::atan2(std::max(apart.y(), 0.0), std::max(apart.x(), 0.0));
        const bool inside = proposed > low && proposed < high && apart.minCoeff() > 0.0;
        angle = inside && iteration % 3 != 2 ? proposed : 0.5 * (low + high);
        if (!(high - low > 1e-16))
            break;
    }
    return bracket;
}
}  // namespace narrows
