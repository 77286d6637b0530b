// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PlanarCertificates.h"

#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// Where a link comes nearest to a point.
struct Approach
{
    Vector2d apart;  ///< from the point to the link
    double square;   ///< its squared length
    bool side;       ///< it is not an end of the link
};

Approach approach(const LinkMotion<2> &link, const Vector2d &point)
{
    const Vector2d along = link.b.position - link.a.position;
    const Vector2d apart = link.a.position - point;
    const double foot = -along.dot(apart);
    const double square = along.squaredNorm();
    if (!(foot > 0.0))
        return {apart, apart.squaredNorm(), false};
    if (foot >= square)
    {
        const Vector2d tip = link.b.position - point;
        return {tip, tip.squaredNorm(), false};
    }
    const Vector2d nearest = apart + foot / square * along;
    return {nearest, nearest.squaredNorm(), true};
}

/// The unit normal of a link that points to the side where `direction` does.
Vector2d normalTowards(const LinkMotion<2> &link, const Vector2d &direction)
{
    const Vector2d along = (link.b.position - link.a.position).normalized();
    const Vector2d normal(-along.y(), along.x());
    return normal.dot(direction) < 0.0 ? Vector2d(-normal) : normal;
}

/// Lower bound, all along the stretch, of the distance of two links of which `link` shows the other its side.
double leastBeside(const LinkMotion<2> &link, const LinkMotion<2> &other, const Vector2d &direction)
{
    const Vector2d normal = normalTowards(link, direction);
    return std::min(link.leastBeside(normal, other.a), link.leastBeside(normal, other.b));
}

/// Do the segments cross?
bool cross(const LinkMotion<2> &link, const LinkMotion<2> &other)
{
    const auto turn = [](const Vector2d &a, const Vector2d &b, const Vector2d &c)
    {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    const Vector2d &a = link.a.position, &b = link.b.position, &c = other.a.position, &d = other.b.position;
    return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}
}  // namespace

Finding examine(const LinkMotion<2> &link, double reach, const Circle &circle)
{
    const double contact = link.radius + circle.radius;
    const Approach nearest = approach(link, circle.center);
    if (nearest.square > (contact + reach) * (contact + reach))
        return Finding::Clear;
    if (nearest.square <= contact * contact)
        return Finding::Touching;
    const Vector2d direction = nearest.apart / std::sqrt(nearest.square);
    const double least = nearest.side ? link.leastBeside(-direction, resting<2>(circle.center))
                                      : link.leastAlong(direction) - direction.dot(circle.center);
    return least > contact ? Finding::Clear : Finding::Unsure;
}

Finding examine(const LinkMotion<2> &link, double reach, const SuperellipseGeometry &shape)
{
    const auto found = shape.separate(link.a.position, link.b.position, link.radius, link.radius + reach);
    if (found.lower > link.radius + reach)
        return Finding::Clear;
    if (found.lower <= link.radius)
        return Finding::Touching;
    const Vector2d &direction = found.direction;
    if (link.leastAlong(direction) - direction.dot(shape.center()) - shape.support(direction) > link.radius)
        return Finding::Clear;

    // While the link turns by up to `angle` either way, no point of the shape gets further towards it than the corner
    // between the shape's tangents at these angles.
    const double angle = std::clamp(link.turn * link.half, 1e-7, 1.0);
    if (angle < link.turn * link.half)
        return Finding::Unsure;
    const Vector2d normal = -normalTowards(link, -direction);
    const Vector2d along(-normal.y(), normal.x());
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double ahead = shape.support(cosine * normal + sine * along);
    const double behind = shape.support(cosine * normal - sine * along);
    const Vector2d corner =
        shape.center() + (ahead + behind) / (2.0 * cosine) * normal + (ahead - behind) / (2.0 * sine) * along;
    return link.leastBeside(-normal, resting<2>(corner)) > link.radius ? Finding::Clear : Finding::Unsure;
}

Finding examine(const LinkMotion<2> &link, const LinkMotion<2> &other, double reach)
{
    const double contact = link.radius + other.radius;
    // Of two segments that do not cross, an end of one is nearest to the other. All `apart` from `other` to `link`.
    Approach nearest = approach(link, other.a.position);
    const auto consider = [&](const Approach &candidate, double sign)
    {
        if (candidate.square < nearest.square)
            nearest = {sign * candidate.apart, candidate.square, candidate.side};
    };
    consider(approach(link, other.b.position), 1.0);
    consider(approach(other, link.a.position), -1.0);
    consider(approach(other, link.b.position), -1.0);
    if (nearest.square <= contact * contact || cross(link, other))
        return Finding::Touching;
    if (nearest.square > (contact + reach) * (contact + reach))
        return Finding::Clear;
    const Vector2d direction = nearest.apart / std::sqrt(nearest.square);
    const bool clear = link.leastApart(other, direction) > contact || leastBeside(link, other, -direction) > contact ||
                       leastBeside(other, link, direction) > contact;
    return clear ? Finding::Clear : Finding::Unsure;
}
}  // namespace narrows
