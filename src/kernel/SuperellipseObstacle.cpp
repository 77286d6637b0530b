// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SuperellipseObstacle.h"

#include <cmath>

namespace narrows
{
using Eigen::Vector2d;

namespace
{
double areaOf(const Superellipse &shape)
{
    const double inverse = 1.0 / shape.exponent;
    const double quarter = std::tgamma(1.0 + inverse) * std::tgamma(1.0 + inverse) / std::tgamma(1.0 + 2.0 * inverse);
    return 4.0 * shape.halfExtents.prod() * quarter;
}
}  // namespace

SuperellipseObstacle::SuperellipseObstacle(const Superellipse &shape, double linkRadius, double reach)
  : center_(shape.center),
    extents_(shape.halfExtents),
    inverseExtents_(shape.halfExtents.cwiseInverse()),
    exponent_(shape.exponent),
    leastExtent_(shape.halfExtents.minCoeff()),
    linkRadius_(linkRadius),
    quartic_(shape.exponent == 4.0)
{
    const double pi = std::acos(-1.0);
    size_ = 2.0 * (std::min(std::sqrt(areaOf(shape) / pi), reach) + linkRadius);
}

/// The gauge takes a tenth of the time of the distance, but does not know where a grown shape ends.
LinkTerm SuperellipseObstacle::pole(const Segment &link) const
{
    double fraction;
    return poleOf(linkRadius_ > 0.0 ? clearance(link) : gauge(link, fraction), size_);
}

SuperellipseObstacle::Level SuperellipseObstacle::level(const Vector2d &from, const Vector2d &along, double t) const
{
    const Vector2d place = from + t * along;
    Vector2d lower;
    const Vector2d raised = raise(place, lower);
    return {t, raised.dot(place), raised.dot(along), (exponent_ - 1.0) * lower.dot(along.cwiseProduct(along))};
}

/// Where |x|^p + |y|^p is least on the segment: its slope is monotone. Newton, kept in its bracket by halving, until
/// isEnough(lower end of the bracket, where it has looked last, upper end).
template <class IsEnough>
double SuperellipseObstacle::deepest(const Vector2d &from, const Vector2d &along, const IsEnough &isEnough) const
{
    Level low = level(from, along, 0.0), high = level(from, along, 1.0);
    if (low.slope >= 0.0)
        return 0.0;
    if (high.slope <= 0.0)
        return 1.0;
    double t = std::min(std::max(-from.dot(along) / along.squaredNorm(), 0.0), 1.0);
    bool close = false;
    for (int iteration = 0; iteration < 60 && !close; ++iteration)
    {
        const Level middle = level(from, along, t);
        (middle.slope < 0.0 ? low : high) = middle;
        if (isEnough(low, middle, high))
            return t;
        const double proposed = t - middle.slope / middle.bend;
        const double next = proposed >= low.t && proposed <= high.t ? proposed : 0.5 * (low.t + high.t);
        close = !(std::abs(next - t) > 1e-8);
        t = next;
    }
    return t;
}

/// The tangents at both ends of a bracket of the least level bound it from below: a step or two tell mostly.
bool SuperellipseObstacle::isMet(const Segment &link) const
{
    if (linkRadius_ > 0.0)
        return clearance(link).value < 0.0;
    const Vector2d from = (link.base - center_).cwiseProduct(inverseExtents_);
    const Vector2d along = link.along.cwiseProduct(inverseExtents_);
    const auto isTold = [this](const Level &low, const Level &middle, const Level &high)
    {
        const double width = high.t - low.t, slope = exponent_ * low.slope, otherSlope = exponent_ * high.slope;
        const double crossing = (high.value - low.value - otherSlope * width) / (slope - otherSlope);
        return middle.value < 1.0 || low.value + crossing * slope >= 1.0;
    };
    return level(from, along, deepest(from, along, isTold)).value < 1.0;
}

/// The distance from a convex shape is convex along the link: an end is nearest if the way to it does not lead back
/// along the link, and an inner point is where the link's line comes nearest.
LinkTerm SuperellipseObstacle::clearance(const Segment &link) const
{
    double fraction;
    LinkTerm meeting = gauge(link, fraction);
    if (meeting.value <= 0.0)
    {
        meeting.value -= linkRadius_;
        return meeting;
    }
    const double likely = std::round(fraction);
    for (const double end : {likely, 1.0 - likely})
    {
        const LinkTerm term = outside(link.at(end), end);
        if ((1.0 - 2.0 * end) * term.slope.force.dot(link.along) >= 0.0)
            return term;
    }
    Vector2d normal = link.normal();
    if (normal.dot(link.base - center_) < 0.0)
        normal = -normal;
    const Vector2d support = center_ + supportPoint(normal);
    return {normal.dot(link.base - support) - linkRadius_, LinkForce::at(link.nearest(support), normal)};
}

LinkTerm SuperellipseObstacle::outside(const Vector2d &point, double fraction) const
{
    const Vector2d from = point - center_;
    Vector2d normal;
    const double distance = pointDistance(from.cwiseAbs(), normal);
    normal = {std::copysign(normal.x(), from.x()), std::copysign(normal.y(), from.y())};
    return {distance - linkRadius_, LinkForce::at(fraction, normal)};
}

/// m (g - 1) with m the lesser half extent and g = (|x/a|^p + |y/b|^p)^(1/p) at its least along the link, which is at
/// `fraction`.
LinkTerm SuperellipseObstacle::gauge(const Segment &link, double &fraction) const
{
    const Vector2d from = (link.base - center_).cwiseProduct(inverseExtents_);
    const Vector2d along = link.along.cwiseProduct(inverseExtents_);
    fraction = deepest(from, along, [](const Level &, const Level &, const Level &) { return false; });
    Vector2d lower;
    const Vector2d scaled = from + fraction * along;
    const Vector2d raised = raise(scaled, lower);
    const double power = raised.dot(scaled);
    if (!(power > 0.0))
        return {-leastExtent_, {}};
    const double gauge = root(power);
    const double slope = leastExtent_ * gauge / power;
    return {leastExtent_ * (gauge - 1.0), LinkForce::at(fraction, slope * raised.cwiseProduct(inverseExtents_))};
}

/// Relative to the center: the shape's point that lies furthest in a direction.
Vector2d SuperellipseObstacle::supportPoint(const Vector2d &direction) const
{
    const Vector2d scaled = direction.cwiseProduct(extents_).cwiseAbs();
    Vector2d corner;
    if (quartic_)
    {
        corner = {std::cbrt(scaled.x()), std::cbrt(scaled.y())};
        const Vector2d square = corner.cwiseProduct(corner);
        corner /= std::sqrt(square.norm());
    }
    else
    {
        const double root = 1.0 / (exponent_ - 1.0);
        corner = {std::pow(scaled.x(), root), std::pow(scaled.y(), root)};
        corner /= std::pow(scaled.dot(corner), 1.0 / exponent_);
    }
    corner = corner.cwiseProduct(extents_);
    return {std::copysign(corner.x(), direction.x()), std::copysign(corner.y(), direction.y())};
}

/// Distance of `corner`, a point outside, relative to the center and in the first quadrant, and the normal of the
/// boundary that points to it. For the boundary's point (a (1 - t) / N, b t / N) the way to `corner` times the tangent
/// falls from t = 0 to 1 and has one root there: Newton, kept in its bracket by halving.
double SuperellipseObstacle::pointDistance(const Vector2d &corner, Vector2d &normal) const
{
    const double a = extents_.x();
    const double b = extents_.y();
    const double p = exponent_;
    double low = 0.0, high = 1.0;
    double t = corner.y() / b / (corner.x() / a + corner.y() / b);
    Vector2d apart;
    bool close = false;  // so close that the next step would be lost in rounding: the error is squared in every step
    for (int iteration = 0; iteration < 100; ++iteration)
    {
        Vector2d lower;
        const Vector2d raised = raise({1.0 - t, t}, lower);
        const double power = raised.dot(Vector2d(1.0 - t, t));
        const double norm = root(power);
        // The point (a x, b y), its normal (u / a, v / b) with u = x^(p - 1) and v = y^(p - 1); derivatives by t.
        const double scale = norm / power;
        const double x = (1.0 - t) / norm;
        const double y = t / norm;
        const double u = raised.x() * scale;
        const double v = raised.y() * scale;
        normal = {u / a, v / b};
        apart = {corner.x() - a * x, corner.y() - b * y};
        if (close)
            break;
        const double dx = -v / (norm * norm);
        const double dy = u / (norm * norm);
        const double du = (p - 1.0) * lower.x() * scale * norm * dx;
        const double dv = (p - 1.0) * lower.y() * scale * norm * dy;
        const double across = apart.y() * normal.x() - apart.x() * normal.y();
        const double slope = (apart.y() * du - b * dy * u) / a - (apart.x() * dv - a * dx * v) / b;
        (across > 0.0 ? low : high) = t;
        const double proposed = t - across / slope;
        const double next = proposed >= low && proposed <= high ? proposed : 0.5 * (low + high);
        close = !(std::abs(next - t) > 1e-8);
        t = next;
    }
    normal.normalize();
    return normal.dot(apart);
}
}  // namespace narrows
