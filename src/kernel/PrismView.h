// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// A segment in the coordinates of a prism, for distances. Lives no longer than the prism.
/// Inline where it is what a checker's time goes into.
class PrismView
{
public:
    /// How far beyond the plane of a face the segment is: linear along it, negative inside.
    struct Height
    {
        double start;            ///< where the segment begins
        double rate;             ///< of change along the segment, from its beginning to its end
        Eigen::Vector3d normal;  ///< unit, outwards

        /// \param t share of the segment, from 0 to 1
        double at(double t) const { return start + t * rate; }
    };

    /// \param along to the segment's other end
    PrismView(const Eigen::Vector3d &from, const Eigen::Vector3d &along, const Prism &prism)
      : from_(from), along_(along), vertices_(prism.vertices), half_(prism.halfLength)
    {
    }

    /// The point at that share of the segment.
    Eigen::Vector3d at(double t) const { return from_ + t * along_; }

    /// From the prism's nearest point to the segment's point; zero inside.
    Eigen::Vector3d excess(double t) const
    {
        const Eigen::Vector3d x = at(t);
        Eigen::Vector3d apart(0.0, 0.0, x.z() - std::clamp(x.z(), -half_, half_));
        double least = std::numeric_limits<double>::infinity();
        bool inside = true;
        for (std::size_t i = 0; i < vertices_.size(); ++i)
        {
            const Eigen::Vector2d &vertex = vertices_[i];
            const Eigen::Vector2d edge = edgeAfter(i), way = x.head<2>() - vertex;
            inside = inside && cross(edge, way) >= 0.0;
            const Eigen::Vector2d beside = way - std::clamp(edge.dot(way) / edge.squaredNorm(), 0.0, 1.0) * edge;
            if (beside.squaredNorm() < least)
            {
                least = beside.squaredNorm();
                apart.head<2>() = beside;
            }
        }
        if (inside)
            apart.head<2>().setZero();
        return apart;
    }

    /// Where the segment is closest. What is closest seen along the axis is so in space, unless it is beyond an end.
    double closest() const
    {
        const double t = closestInSection();
        return std::abs(at(t).z()) <= half_ ? t : searchClosest();
    }

    /// Where the segment is deepest, or least outside of all faces.
    double deepest() const;

    /// Of the face that a point of the segment is least inside of, or furthest beyond.
    Height highestAt(double t) const;

private:
    /// Where the slope of the squared distance changes its sign.
    struct Bracket
    {
        double low, high;
        double lowSlope, highSlope;
    };

    static double cross(const Eigen::Vector2d &u, const Eigen::Vector2d &v) { return u.x() * v.y() - u.y() * v.x(); }

    template <class Visit>
    void visitFaces(const Visit &visit) const;

    Eigen::Vector2d edgeAfter(std::size_t i) const
    {
        return vertices_[i + 1 < vertices_.size() ? i + 1 : 0] - vertices_[i];
    }

    /// Two convex figures in the plane that do not meet are closest at a corner of one of them. If they meet, the
    /// middle of what they share.
    double closestInSection() const
    {
        const Eigen::Vector2d from = from_.head<2>(), along = along_.head<2>();
        const double square = along.squaredNorm(), inverse = square > 0.0 ? 1.0 / square : 0.0;
        double enter = 0.0, leave = 1.0;  // the stretch on the inner side of all edges so far
        double least = std::numeric_limits<double>::infinity(), best = 0.0;
        const auto consider = [&](double t, double squaredDistance)
        {
            if (squaredDistance < least)
            {
                least = squaredDistance;
                best = t;
            }
        };
        for (std::size_t i = 0; i < vertices_.size(); ++i)
        {
            const Eigen::Vector2d edge = edgeAfter(i), way = from - vertices_[i];
            const double corner = std::clamp(-along.dot(way) * inverse, 0.0, 1.0);
            consider(corner, (way + corner * along).squaredNorm());
            const double start = cross(edge, way), rate = cross(edge, along);
            if (start < 0.0 || start + rate < 0.0)
            {
                enter = rate > 0.0 ? std::max(enter, -start / rate) : start < 0.0 ? 2.0 : enter;
                leave = rate < 0.0 ? std::min(leave, -start / rate) : leave;
            }
            for (const double end : {0.0, 1.0})
                if (const double across = start + end * rate; across < 0.0)
                {
                    const double place = edge.dot(way + end * along), length = edge.squaredNorm();
                    if (place > 0.0 && place < length)
                        consider(end, across * across / length);
                }
        }
        return enter <= leave ? 0.5 * (enter + leave) : best;
    }

    double searchClosest() const;
    void narrow(Bracket &bracket, double t) const;
    double slope(double t) const { return excess(t).dot(along_); }

    Eigen::Vector3d from_, along_;
    const std::vector<Eigen::Vector2d> &vertices_;
    double half_;
};
}  // namespace narrows
