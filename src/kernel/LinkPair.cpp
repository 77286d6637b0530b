// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/LinkPair.h"

#include <limits>

#include "kernel/Cross.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// Are the ends of the second segment on different sides of the line through the first?
bool divides(const Segment &first, const Segment &second)
{
    return cross(first.along, second.base - first.base) * cross(first.along, second.tip() - first.base) < 0.0;
}

/// Calls visit(point of the first - point of the second, where on the first, where on the second) for both ends of
/// either segment against the other: where segments do not cross, one of these pairs is the nearest.
template <class Visit>
void visitEnds(const Segment &first, const Segment &second, Visit &&visit)
{
    for (const double end : {0.0, 1.0})
    {
        const double here = first.nearest(second.at(end));
        visit(first.at(here) - second.at(end), here, end);
        const double there = second.nearest(first.at(end));
        visit(first.at(end) - second.at(there), end, there);
    }
}

PairTerm distance(const Segment &first, const Segment &second)
{
    double nearest = std::numeric_limits<double>::infinity();
    Vector2d way = Vector2d::Zero();
    double here = 0.0, there = 0.0;
    visitEnds(first, second,
              [&](const Vector2d &apart, double fraction, double other)
              {
                  if (!(apart.squaredNorm() < nearest))
                      return;
                  nearest = apart.squaredNorm();
                  way = apart;
                  here = fraction;
                  there = other;
              });
    const double length = std::sqrt(nearest);
    const Vector2d normal = length > 0.0 ? Vector2d(way / length) : first.normal();
    return {length, LinkForce::at(here, normal), LinkForce::at(there, -normal)};
}

/// Minus the least shift along the normal of `base` that takes the other segment off it.
void overlapAlong(const Segment &base, const Segment &other, double &value, LinkForce &onBase, LinkForce &onOther)
{
    value = -std::numeric_limits<double>::infinity();
    for (const Vector2d &normal : {base.normal(), Vector2d(-base.normal())})
    {
        const double end = normal.dot(other.along) < 0.0 ? 1.0 : 0.0;
        const double height = normal.dot(other.at(end) - base.base);
        if (!(height > value))
            continue;
        value = height;
        onBase = LinkForce::at(base.foot(other.at(end)), -normal);
        onOther = LinkForce::at(end, normal);
    }
}

PairTerm overlap(const Segment &first, const Segment &second)
{
    PairTerm one, two;
    overlapAlong(first, second, one.value, one.first, one.second);
    overlapAlong(second, first, two.value, two.second, two.first);
    return one.value > two.value ? one : two;
}
}  // namespace

bool cross(const Segment &first, const Segment &second)
{
    return divides(first, second) && divides(second, first);
}

PairTerm pairClearance(const Segment &first, const Segment &second, double radius)
{
    PairTerm term = cross(first, second) ? overlap(first, second) : distance(first, second);
    term.value -= radius;
    return term;
}

PairTerm pairPole(const Segment &first, const Segment &second, double radius, double size)
{
    SmoothMinimum minimum(radius);
    visitEnds(first, second,
              [&](const Vector2d &apart, double fraction, double other) { minimum.add(apart, fraction, other); });
    const bool free = minimum.positive() && !cross(first, second);
    const PairTerm clearance = free ? minimum.pairValue() : pairClearance(first, second, radius);
    const double slope = poleSlope(clearance.value, size);
    return {poleOf(clearance.value, size), clearance.first.times(slope), clearance.second.times(slope)};
}
}  // namespace narrows
