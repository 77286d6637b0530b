// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PrismView.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

template <class Visit>
void PrismView::visitFaces(const Visit &visit) const
{
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
        const Vector2d edge = edgeAfter(i).normalized(), way = from_.head<2>() - vertices_[i];
        visit(Height{-cross(edge, way), -cross(edge, along_.head<2>()), {edge.y(), -edge.x(), 0.0}});
    }
    for (const double side : {-1.0, 1.0})
        if (std::isfinite(half_))
            visit(Height{side * from_.z() - half_, side * along_.z(), side * Vector3d::UnitZ()});
}

/// The lowest point of the highest of the heights, found by going from one to the next.
double PrismView::deepest() const
{
    double t = 0.0;
    Height highest = highestAt(0.0);
    while (highest.rate < 0.0)
    {
        double next = 1.0;
        Height steeper = highest;
        visitFaces(
            [&](const Height &other)
            {
                if (!(other.rate > highest.rate))
                    return;
                const double crossing = (highest.start - other.start) / (other.rate - highest.rate);
                if (crossing < next || (crossing == next && other.rate > steeper.rate))
                {
                    next = crossing;
                    steeper = other;
                }
            });
        t = std::max(t, next);
        if (!(next < 1.0))
            break;
        highest = steeper;
    }
    return t;
}

PrismView::Height PrismView::highestAt(double t) const
{
    Height highest{-std::numeric_limits<double>::infinity(), 0.0, Vector3d::UnitZ()};
    visitFaces(
        [&](const Height &face)
        {
            if (face.at(t) > highest.at(t) || (face.at(t) == highest.at(t) && face.rate > highest.rate))
                highest = face;
        });
    return highest;
}

/// The squared distance along the segment is convex and consists of parabolas, which meet where the segment crosses
/// the plane of a face, or one at right angles to a side that bounds what is nearest to it: its slope, linear
/// between such places, is looked at there and at the ends.
double PrismView::searchClosest() const
{
    Bracket bracket{0.0, 1.0, slope(0.0), 0.0};
    if (bracket.lowSlope >= 0.0)
        return 0.0;
    bracket.highSlope = slope(1.0);
    if (bracket.highSlope <= 0.0)
        return 1.0;
    const Vector2d from = from_.head<2>(), along = along_.head<2>();
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
        const Vector2d edge = edgeAfter(i), way = vertices_[i] - from;
        narrow(bracket, cross(edge, way) / cross(edge, along));
        narrow(bracket, edge.dot(way) / edge.dot(along));
        narrow(bracket, edge.dot(way + edge) / edge.dot(along));
    }
    narrow(bracket, (-half_ - from_.z()) / along_.z());
    narrow(bracket, (half_ - from_.z()) / along_.z());
    return bracket.low + (bracket.high - bracket.low) * (bracket.lowSlope / (bracket.lowSlope - bracket.highSlope));
}

void PrismView::narrow(Bracket &bracket, double t) const
{
    if (!(t > bracket.low && t < bracket.high))  // written so that a NaN is left out too
        return;
    const double there = slope(t);
    (there < 0.0 ? bracket.low : bracket.high) = t;
    (there < 0.0 ? bracket.lowSlope : bracket.highSlope) = there;
}
}  // namespace narrows
