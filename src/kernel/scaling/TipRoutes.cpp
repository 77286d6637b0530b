// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TipRoutes.h"

#include <algorithm>
#include <cmath>

#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"
#include "kernel/scaling/Outline.h"
#include "kernel/scaling/TautString.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// Ways around a region run this much outside it, relative to its size: what is pulled taut must not touch it.
constexpr double lift = 1e-6;
}  // namespace

TipRoutes::TipRoutes(const std::vector<ConvexSection> &sections, const std::vector<double> &clearances,
                     std::vector<Vector2d> waypoints)
  : waypoints_(std::move(waypoints))
{
    merge(sections, clearances);
    for (std::size_t r = 0; r < regions_.size(); ++r)
        for (const Vector2d &point : waypoints_)
            if (!fault_ && contains(Polygon{regions_[r]}, point))
                fault_.failure = merged_[r] ? ScalingFailure::Overlap : ScalingFailure::TipBlocked;
    for (std::size_t i = 0; !fault_ && i < legs(); ++i)
    {
        const std::size_t first = hits_.size();
        findHits(i);
        findBeside(i);
        std::sort(hits_.begin() + static_cast<std::ptrdiff_t>(first), hits_.end(),
                  [](const Hit &a, const Hit &b) { return a.enters < b.enters; });
    }
}

void TipRoutes::merge(const std::vector<ConvexSection> &sections, const std::vector<double> &clearances)
{
    for (std::size_t s = 0; s < sections.size(); ++s)
    {
        Outline outline = sections[s].dangerPolygon(clearances[s]);
        bool merged = false;
        // The hull of two regions may reach a third one that was looked at before.
        for (std::size_t r = 0; r < regions_.size();)
        {
            if (!overlap(outline, regions_[r]))
            {
                ++r;
                continue;
            }
            outline.insert(outline.end(), regions_[r].begin(), regions_[r].end());
            outline = convexHull(std::move(outline));
            regions_.erase(regions_.begin() + static_cast<std::ptrdiff_t>(r));
            merged_.erase(merged_.begin() + static_cast<std::ptrdiff_t>(r));
            merged = true;
            r = 0;
        }
        regions_.push_back(std::move(outline));
        merged_.push_back(merged);
    }
}

void TipRoutes::findHits(std::size_t leg)
{
    const Vector2d &from = waypoints_[leg];
    const Vector2d &to = waypoints_[leg + 1];
    const double length = (to - from).norm();
    for (std::size_t r = 0; r < regions_.size() && length > 0.0; ++r)
    {
        const std::optional<Stretch> inside = clip(from, to, regions_[r]);
        const double least = lift * extent(regions_[r]) / length;
        if (!inside || inside->leaves - inside->enters <= least || inside->enters >= 1.0 || inside->leaves <= 0.0)
            continue;
        Hit hit{leg, r, inside->enters, inside->leaves, inside->entryEdge, inside->exitEdge, true, 0.0, false};
        const double left = around(hit, true);
        const double right = around(hit, false);
        hit.leftIsShorter = left <= right;
        hit.detour = std::abs(left - right);
        hits_.push_back(hit);
    }
}

/// Regions that an arm swinging along the leg would be wrapped around.
void TipRoutes::findBeside(std::size_t leg)
{
    const Vector2d &from = waypoints_[leg];
    const Vector2d &to = waypoints_[leg + 1];
    const Vector2d way = to - from;
    const double turn = cross(from, to);
    const auto isSwept = [&](const Vector2d &corner)
    {
        return turn * cross(from, corner) > 0.0 && turn * cross(corner, to) > 0.0 &&
               turn * cross(way, corner - from) > 0.0;
    };
    for (std::size_t r = 0; r < regions_.size(); ++r)
    {
        const Outline &outline = regions_[r];
        if (clip(from, to, outline, 0.0, 1.0) || std::none_of(outline.begin(), outline.end(), isSwept))
            continue;
        const Vector2d center = middle(outline);
        const double at = std::clamp(way.dot(center - from) / way.squaredNorm(), 0.0, 1.0);
        const Vector2d near = from + at * way;
        const std::optional<Stretch> inside = clip(near, center, outline);
        bool free = inside && inside->enters > 0.0;
        for (std::size_t other = 0; free && other < regions_.size(); ++other)
            free = other == r || !clip(near, center, regions_[other], 0.0, inside->enters);
        if (!free)
            continue;
        // With the region on the left, a clockwise turn leads past it on the other side.
        Hit hit{leg, r, at, at, inside->entryEdge, inside->entryEdge, cross(way, center - from) > 0.0, 0.0, true};
        std::vector<Vector2d> round{from};
        visit(hit, true, round);
        round.push_back(to);
        hit.detour = lengthOf(pull(round)) - way.norm();
        hits_.push_back(hit);
    }
}

/// Length of the way around a region, from where the leg enters it to where it leaves it.
double TipRoutes::around(const Hit &hit, bool left) const
{
    const Vector2d &from = waypoints_[hit.leg];
    const Vector2d way = waypoints_[hit.leg + 1] - from;
    std::vector<Vector2d> points{from + hit.enters * way};
    bypass(hit, left != hit.leftIsShorter, points);
    points.push_back(from + hit.leaves * way);
    return lengthOf(points);
}

/// Appends the stretch of a leg where it passes a region.
void TipRoutes::visit(const Hit &hit, bool longer, std::vector<Vector2d> &way) const
{
    const Vector2d &from = waypoints_[hit.leg];
    const Vector2d &to = waypoints_[hit.leg + 1];
    if (hit.beside && !longer)
        return;
    const double off = hit.beside ? 0.0 : lift * extent(regions_[hit.region]) / (to - from).norm();
    way.push_back(from + std::max(0.0, hit.enters - off) * (to - from));
    bypass(hit, longer, way);
    way.push_back(from + std::min(1.0, hit.leaves + off) * (to - from));
}

/// Appends the corners between entry and exit, lifted a little off the region.
void TipRoutes::bypass(const Hit &hit, bool longer, std::vector<Vector2d> &way) const
{
    const Outline &outline = regions_[hit.region];
    const Vector2d center = middle(outline);
    const auto append = [&](std::size_t corner)
    {
        way.push_back(outline[corner] + lift * (outline[corner] - center));
    };
    const std::size_t size = outline.size();
    const bool left = longer != hit.leftIsShorter;  // counter-clockwise
    const std::size_t edges = left ? hit.exitEdge + size - hit.entryEdge : hit.entryEdge + size - hit.exitEdge;
    const std::size_t corners = hit.beside ? size + 1 : edges % size;
    for (std::size_t k = 0; k < corners; ++k)
        append((left ? hit.entryEdge + 1 + k : hit.entryEdge + 2 * size - k) % size);
}

/// The shortest way of the same homotopy class.
std::vector<Vector2d> TipRoutes::pull(const std::vector<Vector2d> &way) const
{
    TautString string(regions_, way.front());
    for (const Vector2d &point : way)
        string.moveTip(point);
    std::vector<Vector2d> corners{way.front()};
    for (const TautString::Contact &contact : string.contacts())
        corners.push_back(contact.point);
    corners.push_back(way.back());
    return corners;
}

std::vector<Vector2d> TipRoutes::leg(std::size_t index, const std::vector<bool> &longer) const
{
    const Vector2d &from = waypoints_[index];
    const Vector2d &to = waypoints_[index + 1];
    std::vector<Vector2d> way{from};
    for (std::size_t h = 0; h < hits_.size(); ++h)
        if (hits_[h].leg == index)
            visit(hits_[h], h < longer.size() && longer[h], way);
    way.push_back(to);
    return way.size() == 2 ? way : pull(way);
}
}  // namespace narrows
