// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TautString.h"

#include <algorithm>
#include <cmath>

#include "kernel/Cross.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// A contact is let go only when its turn is beyond zero by this angle, so that the corner is swept again, and found,
/// when the tip comes back.
constexpr double releaseAngle = 1e-9;
/// Corners this close to where a sweep begins, by angle, were passed before.
constexpr double sweptAngle = 1e-12;
}  // namespace

/// The triangle that the last segment passes over.
struct TautString::Sweep
{
    const Vector2d &pivot;
    const Vector2d &from;
    const Vector2d &to;
    Vector2d first;  ///< the segment before and after, and the tip's way
    Vector2d last;
    Vector2d way;
    double firstLength, lastLength, wayLength;
    double side;  ///< 1: turns to the left

    Sweep(const Vector2d &pivotPoint, const Vector2d &fromPoint, const Vector2d &toPoint)
      : pivot(pivotPoint),
        from(fromPoint),
        to(toPoint),
        first(from - pivot),
        last(to - pivot),
        way(to - from),
        firstLength(first.norm()),
        lastLength(last.norm()),
        wayLength(way.norm()),
        side(cross(first, last) > 0.0 ? 1.0 : -1.0)
    {
    }

    /// Does the triangle meet the circle about a shape? May say yes though it does not.
    bool meets(const Shape &shape) const
    {
        const Vector2d toCenter = shape.center - pivot;
        return side * cross(first, toCenter) >= -shape.bound * firstLength &&
               side * cross(toCenter, last) >= -shape.bound * lastLength &&
               side * cross(way, shape.center - from) >= -shape.bound * wayLength;
    }

    bool contains(const Vector2d &corner) const
    {
        const Vector2d toCorner = corner - pivot;
        const double turn = side * cross(first, toCorner);
        return turn > 0.0 && side * cross(toCorner, last) >= 0.0 && side * cross(way, corner - from) >= 0.0 &&
               turn > sweptAngle * firstLength * toCorner.norm();
    }

    /// Is the first corner passed before the second? The farther of two at once.
    bool isBefore(const Vector2d &corner, const Vector2d &other) const
    {
        const double turn = side * cross(corner - pivot, other - pivot);
        return turn > 0.0 || (turn == 0.0 && (corner - pivot).squaredNorm() > (other - pivot).squaredNorm());
    }

    /// Where the tip is when the segment passes a corner.
    Vector2d tipAt(const Vector2d &corner) const
    {
        const double slope = cross(corner - pivot, way);
        const double t = slope == 0.0 ? 0.0 : -cross(corner - pivot, first) / slope;
        return from + std::clamp(t, 0.0, 1.0) * way;
    }
};

TautString::TautString(std::vector<std::vector<Vector2d>> polygons, const Vector2d &anchor)
  : anchor_(anchor), tip_(anchor)
{
    for (std::vector<Vector2d> &polygon : polygons)
    {
        Shape shape{std::move(polygon), Vector2d::Zero(), 0.0};
        for (const Vector2d &corner : shape.corners)
            shape.center += corner / static_cast<double>(shape.corners.size());
        for (const Vector2d &corner : shape.corners)
            shape.bound = std::max(shape.bound, (corner - shape.center).norm());
        shape.bound *= 1.0 + 1e-9;  // for the rounding of what it is compared with
        shapes_.push_back(std::move(shape));
    }
    contacts_.reserve(64);
}

const Vector2d &TautString::node(std::size_t index) const
{
    if (index == 0)
        return anchor_;
    return index <= contacts_.size() ? contacts_[index - 1].point : tip_;
}

void TautString::moveTip(const Vector2d &to)
{
    while (true)
    {
        Vector2d end = to;
        const bool released = release(tip_, end);
        // What is swept before the contact lets go comes first.
        if (wrap(tip_, end))
            continue;
        tip_ = end;
        if (!released)
            return;
        contacts_.pop_back();
    }
}

/// Does the last contact let go on the way? Then `to` becomes the point where it does.
bool TautString::release(const Vector2d &from, Vector2d &to) const
{
    if (contacts_.empty())
        return false;
    const Contact &last = contacts_.back();
    const Vector2d back = last.point - node(contacts_.size() - 1);
    const Vector2d reach = to - last.point;
    const double after = last.side * cross(back, reach);
    if (after >= -releaseAngle * back.norm() * reach.norm())
        return false;
    const double before = std::max(0.0, last.side * cross(back, from - last.point));
    to = from + before / (before - after) * (to - from);
    return true;
}

/// Wraps the first corner on the way, if there is one; `from` becomes where the tip is then.
bool TautString::wrap(Vector2d &from, const Vector2d &to)
{
    const Sweep sweep(holder(), from, to);
    const Vector2d *found = nullptr;
    std::size_t polygon = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        if (sweep.meets(shapes_[i]))
            for (const Vector2d &corner : shapes_[i].corners)
                if (sweep.contains(corner) && (found == nullptr || sweep.isBefore(corner, *found)))
                {
                    found = &corner;
                    polygon = i;
                }
    if (found == nullptr)
        return false;
    const Vector2d reached = sweep.tipAt(*found);
    const int side = sweep.side > 0.0 ? 1 : -1;
    from = reached;
    contacts_.push_back({*found, polygon, side});
    return true;
}

double TautString::length() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i <= contacts_.size(); ++i)
        sum += (node(i + 1) - node(i)).norm();
    return sum;
}

void TautString::pointsAt(const std::vector<double> &fractions, const Vector2d &end,
                          std::vector<Vector2d> &points) const
{
    points.resize(fractions.size());
    const double whole = length() + (end - tip_).norm();
    const auto at = [&](std::size_t index) -> const Vector2d &
    {
        return index <= contacts_.size() + 1 ? node(index) : end;
    };
    std::size_t segment = 0;
    double begin = 0.0;
    double extent = (at(1) - at(0)).norm();
    for (std::size_t i = 0; i < fractions.size(); ++i)
    {
        const double wanted = fractions[i] * whole;
        while (segment <= contacts_.size() && begin + extent < wanted)
        {
            begin += extent;
            ++segment;
            extent = (at(segment + 1) - at(segment)).norm();
        }
        const double share = extent > 0.0 ? std::clamp((wanted - begin) / extent, 0.0, 1.0) : 0.0;
        points[i] = at(segment) + share * (at(segment + 1) - at(segment));
    }
}
}  // namespace narrows
