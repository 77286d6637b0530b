// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SuperellipseGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// At a point of the boundary, relative to the center; infinite where the boundary is flat.
double SuperellipseGeometry::curvatureRadius(const Vector2d &point) const
{
    const Vector2d scaled = point.cwiseQuotient(halfExtents_).cwiseAbs();
    const Vector2d bend = quartic_
                              ? Vector2d(scaled.cwiseProduct(scaled))
                              : Vector2d(std::pow(scaled.x(), exponent_ - 2.0), std::pow(scaled.y(), exponent_ - 2.0));
    const Vector2d slope = bend.cwiseProduct(scaled).cwiseQuotient(halfExtents_);
    const Vector2d second = (exponent_ - 1.0) * bend.cwiseQuotient(halfExtents_.cwiseProduct(halfExtents_));
    const double square = slope.squaredNorm();
    return square * std::sqrt(square) / (second.x() * slope.y() * slope.y() + second.y() * slope.x() * slope.x());
}

bool SuperellipseGeometry::farther(const Vector2d &a, const Vector2d &b, double threshold) const
{
    return segmentDistance(a, b, {threshold, threshold, tolerance(), 0.0}).lower > threshold;
}

double SuperellipseGeometry::distance(const Vector2d &a, const Vector2d &b) const
{
    return segmentDistance(a, b, {-1.0, std::numeric_limits<double>::infinity(), tolerance(), 0.0}).lower;
}

SuperellipseGeometry::Separation SuperellipseGeometry::separate(const Vector2d &a, const Vector2d &b, double little,
                                                                double enough) const
{
    return segmentDistance(a, b, {little, enough, tolerance(), 1.0 / 32.0});
}

/// The distance to the points of a line is convex along it, so that the nearest point is where the line comes nearest
/// to the shape, or the end on that side.
SuperellipseGeometry::Separation SuperellipseGeometry::segmentDistance(const Vector2d &a, const Vector2d &b,
                                                                       const Purpose &purpose) const
{
    const Vector2d along = b - a;
    const double length = along.norm();
    if (!(length > 0.0))
        return pointDistance(a, purpose);

    Vector2d normal(-along.y() / length, along.x() / length);
    const double offset = normal.dot(a - center_);
    if (offset < 0.0)
        normal = -normal;
    double height;
    const Vector2d nearest = supportPoint(normal, height);
    const double gap = std::abs(offset) - height;  // between the line and the shape
    if (gap > purpose.enough && gap > 0.0)
        return {gap, gap, normal};

    const bool lineMisses = gap > 0.0;
    const double foot = along.dot(center_ + nearest - a) / (length * length);
    if (lineMisses && foot >= 0.0 && foot <= 1.0)
        return {gap, gap, normal};
    if (lineMisses)
        return pointDistance(foot < 0.0 ? a : b, purpose);
    // The line meets the shape. Where value() falls towards an end, the shape lies beyond it.
    if (value(a) <= 0.0 || value(b) <= 0.0)
        return {0.0, 0.0, normal};
    if (slope(a, along) >= 0.0)
        return pointDistance(a, purpose);
    if (slope(b, along) <= 0.0)
        return pointDistance(b, purpose);
    return {0.0, 0.0, normal};
}

/// Maximises the separation d . (point - center) - support(d) over unit directions d in the point's quadrant. Every d
/// gives a lower bound on the distance and every support point an upper one; the derivative over the angle is monotone.
SuperellipseGeometry::Separation SuperellipseGeometry::pointDistance(const Vector2d &point,
                                                                     const Purpose &purpose) const
{
    const Vector2d corner = (point - center_).cwiseAbs();
    const double outside = value(point);
    if (outside <= 0.0)
        return {0.0, 0.0, Vector2d::UnitX()};

    // First guess: the normal where the ray from the center leaves the shape.
    const Vector2d scaled = corner.cwiseQuotient(halfExtents_);
    const auto raised = [this](double s)
    {
        return quartic_ ? s * s * s : std::pow(s, exponent_ - 1.0);
    };
    double angle = std::atan2(raised(scaled.y()) / halfExtents_.y(), raised(scaled.x()) / halfExtents_.x());
    double low = 0.0;
    double high = std::acos(0.0);
    Separation found{0.0, corner.norm(), corner / corner.norm()};
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        const Vector2d direction(std::cos(angle), std::sin(angle));
        double height;
        const Vector2d nearest = supportPoint(direction, height);
        const Vector2d apart = corner - nearest.cwiseAbs();
        const double lower = direction.dot(corner) - height;
        if (lower > found.lower)
        {
            found.lower = lower;
            found.direction = direction;
        }
        found.upper = std::min(found.upper, apart.norm());
        const double open = found.upper - found.lower;
        if (found.lower > purpose.enough || found.upper <= purpose.little || open <= purpose.tolerance ||
            open <= purpose.share * (found.lower - purpose.little))
            break;
        const double turn = direction.x() * apart.y() - direction.y() * apart.x();
        (turn > 0.0 ? low : high) = angle;
        // Newton's step; where the shape is so flat that it leads astray, halve the bracket.
        const double proposed = angle + turn / (direction.dot(apart) + curvatureRadius(nearest));
        angle = proposed > low && proposed < high && iteration % 4 != 3 ? proposed : 0.5 * (low + high);
        if (!(high - low > 1e-16))
            break;
    }
    found.direction.x() = std::copysign(found.direction.x(), point.x() - center_.x());
    found.direction.y() = std::copysign(found.direction.y(), point.y() - center_.y());
    return found;
}
}  // namespace narrows
