// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/ConvexSection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr double fullTurn = 6.283185307179586;
constexpr int chordsPerTurn = 64;

Vector2d outward(const Vector2d &from, const Vector2d &to)
{
    return Vector2d(to.y() - from.y(), from.x() - to.x()).normalized();
}

/// Where on the segment ab, in [0, 1], the point nearest to p lies.
double nearestFraction(const Vector2d &a, const Vector2d &b, const Vector2d &p)
{
    const Vector2d along = b - a;
    const double square = along.squaredNorm();
    return square > 0.0 ? std::clamp(along.dot(p - a) / square, 0.0, 1.0) : 0.0;
}

/// The shortest way found so far from a point of the core to a point of the segment.
struct Way
{
    Vector2d vector = Vector2d::Zero();
    double fraction = 0.0;
    double square = std::numeric_limits<double>::infinity();

    void offer(const Vector2d &from, const Vector2d &to, double at)
    {
        const Vector2d way = to - from;
        if (way.squaredNorm() < square)
            *this = {way, at, way.squaredNorm()};
    }
};

void appendArc(const Vector2d &corner, double radius, double from, double turn, std::vector<Vector2d> &polygon)
{
    const int chords = std::max(1, static_cast<int>(std::ceil(chordsPerTurn * turn / fullTurn)));
    for (int i = 0; i <= chords; ++i)
    {
        const double angle = from + turn * i / chords;
        polygon.push_back(corner + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
}
}  // namespace

ConvexSection::ConvexSection(std::vector<Vector2d> corners, double radius, Interval span)
  : corners_(std::move(corners)), radius_(radius), span_(span)
{
    if (corners_.empty() || !(radius >= 0.0) || !std::isfinite(radius) || !(span.lower <= span.upper))
        throw std::invalid_argument("a section needs a corner, a radius >= 0 and a span in order");
    Vector2d low = corners_[0], high = corners_[0];
    for (const Vector2d &corner : corners_)
    {
        if (!corner.allFinite())
            throw std::invalid_argument("the corners of a section must be finite");
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    center_ = 0.5 * (low + high);
    bound_ = 0.0;
    for (const Vector2d &corner : corners_)
        bound_ = std::max(bound_, (corner - center_).norm());
    bound_ += radius_;
}

double ConvexSection::coreDistance(const Vector2d &a, const Vector2d &b) const
{
    if (corners_.size() == 1)
        return std::sqrt(squaredDistance(a, b, corners_[0]));
    bool inside = corners_.size() > 2;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const Vector2d &from = corners_[i];
        const Vector2d &to = corners_[next(i)];
        inside = inside && cross(to - from, a - from) >= 0.0;
        nearest = std::min(nearest, narrows::distance(a, b, from, to));
    }
    return inside ? 0.0 : nearest;
}

double ConvexSection::distance(const Vector2d &a, const Vector2d &b) const
{
    return std::max(0.0, coreDistance(a, b) - radius_);
}

bool ConvexSection::isCloser(const Vector2d &a, const Vector2d &b, double gap) const
{
    const double far = bound_ + gap;
    return squaredDistance(a, b, center_) < far * far && (corners_.size() == 1 || coreDistance(a, b) < radius_ + gap);
}

ConvexSection::Contact ConvexSection::contact(const Vector2d &a, const Vector2d &b) const
{
    const double core = coreDistance(a, b);
    Way way;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const Vector2d &corner = corners_[i];
        const double t = nearestFraction(a, b, corner);
        way.offer(corner, a + t * (b - a), t);
        const Vector2d edge = corners_[next(i)] - corner;
        way.offer(corner + nearestFraction(corner, corners_[next(i)], a) * edge, a, 0.0);
        way.offer(corner + nearestFraction(corner, corners_[next(i)], b) * edge, b, 1.0);
    }
    if (!(core > 0.0))  // a way between boundaries says nothing where they cross
    {
        way.fraction = nearestFraction(a, b, center_);
        way.vector = a + way.fraction * (b - a) - center_;
    }
    const double length = way.vector.norm();
    const Vector2d away = length > 0.0 ? Vector2d(way.vector / length) : outward(b, a);
    return {std::max(0.0, core - radius_), way.fraction, away};
}

std::optional<Interval> ConvexSection::crossing(int axis, double height, double margin) const
{
    const double grown = radius_ + margin;
    const int other = 1 - axis;
    Interval hits{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const auto add = [&](double value)
    {
        hits = {std::min(hits.lower, value), std::max(hits.upper, value)};
    };
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const double off = height - corners_[i][other];
        if (std::abs(off) <= grown)
        {
            const double half = std::sqrt(grown * grown - off * off);
            add(corners_[i][axis] - half);
            add(corners_[i][axis] + half);
        }
        const Vector2d &to = corners_[next(i)];
        const Vector2d shift = grown * outward(corners_[i], to);
        const double first = off - shift[other];
        const double second = height - to[other] - shift[other];
        if (first * second < 0.0)  // the edge's offset crosses the line
            add(corners_[i][axis] + shift[axis] + first / (first - second) * (to[axis] - corners_[i][axis]));
    }
    return hits.lower <= hits.upper ? std::optional<Interval>(hits) : std::nullopt;
}

std::vector<Vector2d> ConvexSection::dangerPolygon(double margin) const
{
    const double grown = radius_ + margin;
    std::vector<Vector2d> polygon;
    if (corners_.size() == 1)
    {
        appendArc(corners_[0], grown, 0.0, fullTurn, polygon);
        polygon.pop_back();
        return polygon;
    }
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const Vector2d &before = corners_[i == 0 ? corners_.size() - 1 : i - 1];
        const Vector2d in = outward(before, corners_[i]);
        const Vector2d out = outward(corners_[i], corners_[next(i)]);
        double turn = std::atan2(cross(in, out), in.dot(out));
        if (corners_.size() == 2)
            turn = 0.5 * fullTurn;
        appendArc(corners_[i], grown, std::atan2(in.y(), in.x()), turn, polygon);
    }
    return polygon;
}

std::vector<Vector2d> convexHull(std::vector<Vector2d> points)
{
    const auto before = [](const Vector2d &a, const Vector2d &b)
    {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<Vector2d> hull;
    for (int side = 0; side < 2; ++side)  // the lower chain, then the upper one
    {
        const std::size_t fixed = hull.size() + 1;
        for (const Vector2d &point : points)
        {
            while (hull.size() > fixed && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}
}  // namespace narrows
