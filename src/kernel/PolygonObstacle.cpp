// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PolygonObstacle.h"

#include <algorithm>
#include <limits>

#include "kernel/ConvexParts.h"
#include "kernel/LinkPair.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
std::vector<Segment> edgesOf(const Polygon &polygon)
{
    std::vector<Segment> edges;
    const std::vector<Vector2d> &corners = polygon.vertices;
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.push_back(Segment::between(corners[i], corners[(i + 1) % corners.size()]));
    return edges;
}

double areaOf(const std::vector<Segment> &edges)
{
    double twice = 0.0;
    for (const Segment &edge : edges)
        twice += edge.base.x() * edge.along.y() - edge.base.y() * edge.along.x();
    return 0.5 * std::abs(twice);
}

/// Calls visit(way from the polygon to the link's point, where that is on the link) for every corner against the link
/// and both ends of the link against every edge: where they do not meet, one of these ways is the shortest.
template <class Visit>
void visitWays(const Segment &link, const std::vector<Segment> &edges, Visit &&visit)
{
    const Vector2d tip = link.tip();
    for (const Segment &edge : edges)
    {
        const double fraction = link.nearest(edge.base);
        visit(link.at(fraction) - edge.base, fraction);
        visit(link.base - edge.at(edge.nearest(link.base)), 0.0);
        visit(tip - edge.at(edge.nearest(tip)), 1.0);
    }
}

/// The greatest separation of the link and a convex polygon along the normals of either; negative if they overlap, and
/// then the least shift that parts them.
LinkTerm separation(const Segment &link, const std::vector<Segment> &edges)
{
    LinkTerm best;
    best.value = -std::numeric_limits<double>::infinity();
    const auto consider = [&best](double value, double fraction, const Vector2d &normal)
    {
        if (value > best.value)
            best = {value, LinkForce::at(fraction, normal)};
    };
    for (const Segment &edge : edges)
    {
        const Vector2d outward = -edge.normal();
        const double end = outward.dot(link.along) < 0.0 ? 1.0 : 0.0;
        consider(outward.dot(link.at(end) - edge.base), end, outward);
    }
    for (const Vector2d &normal : {link.normal(), Vector2d(-link.normal())})
    {
        const auto lower = [&normal](const Segment &a, const Segment &b)
        {
            return normal.dot(a.base) < normal.dot(b.base);
        };
        const Vector2d &top = std::max_element(edges.begin(), edges.end(), lower)->base;
        consider(normal.dot(link.base - top), link.foot(top), normal);
    }
    return best;
}
}  // namespace

PolygonObstacle::PolygonObstacle(const Polygon &polygon, double linkRadius, double reach)
  : polygon_(polygon), box_(bounds({"", polygon})), edges_(edgesOf(polygon)), linkRadius_(linkRadius)
{
    const double pi = std::acos(-1.0);
    size_ = 2.0 * (std::min(std::sqrt(areaOf(edges_) / pi), reach) + linkRadius);
    for (const Polygon &part : convexParts(polygon))
    {
        std::vector<Segment> edges = edgesOf(part);
        std::vector<HalfPlane> inside = insideOf(edges);
        pieces_.push_back({bounds({"", part}), std::move(edges), std::move(inside)});
    }
}

std::vector<PolygonObstacle::HalfPlane> PolygonObstacle::insideOf(const std::vector<Segment> &edges)
{
    std::vector<HalfPlane> inside;
    for (const Segment &edge : edges)
    {
        const Vector2d outward(edge.along.y(), -edge.along.x());
        inside.push_back({outward, outward.dot(edge.base)});
    }
    return inside;
}

/// Whether half-planes leave something of the link (Cyrus and Beck, Generalized two- and three-dimensional clipping,
/// 1978).
bool PolygonObstacle::enters(const Segment &link, const std::vector<HalfPlane> &inside)
{
    double from = 0.0, to = 1.0;
    for (const HalfPlane &half : inside)
    {
        const double start = half.outward.dot(link.base) - half.offset;
        const double slope = half.outward.dot(link.along);
        if (start >= 0.0 && start + slope >= 0.0)
            return false;
        if (start > 0.0)
            from = std::max(from, -start / slope);
        else if (start + slope > 0.0)
            to = std::min(to, -start / slope);
        if (from >= to)
            return false;
    }
    return true;
}

bool PolygonObstacle::isMet(const Segment &link) const
{
    const Bounds box = Bounds::around(link.base, link.tip());
    for (const Piece &piece : pieces_)
        if (box.meets(piece.box) && enters(link, piece.inside))
            return true;
    return linkRadius_ > 0.0 && distance(link).value < linkRadius_;
}

bool PolygonObstacle::meets(const Segment &link) const
{
    if (!box_.meets(Bounds::around(link.base, link.tip())))
        return false;
    return contains(polygon_, link.base) ||
           std::any_of(edges_.begin(), edges_.end(), [&link](const Segment &edge) { return cross(link, edge); });
}

LinkTerm PolygonObstacle::distance(const Segment &link) const
{
    double nearest = std::numeric_limits<double>::infinity();
    Vector2d way = Vector2d::Zero();
    double where = 0.0;
    visitWays(link, edges_,
              [&](const Vector2d &apart, double fraction)
              {
                  if (!(apart.squaredNorm() < nearest))
                      return;
                  nearest = apart.squaredNorm();
                  way = apart;
                  where = fraction;
              });
    const double length = std::sqrt(nearest);
    return {length, LinkForce::at(where, length > 0.0 ? Vector2d(way / length) : link.normal())};
}

LinkTerm PolygonObstacle::depth(const Segment &link) const
{
    LinkTerm deepest;
    const Bounds box = Bounds::around(link.base, link.tip());
    for (const Piece &piece : pieces_)
    {
        if (!box.meets(piece.box))
            continue;
        const LinkTerm term = separation(link, piece.edges);
        if (term.value < deepest.value)
            deepest = term;
    }
    return deepest;
}

LinkTerm PolygonObstacle::clearance(const Segment &link) const
{
    LinkTerm term = meets(link) ? depth(link) : distance(link);
    term.value -= linkRadius_;
    return term;
}

LinkTerm PolygonObstacle::pole(const Segment &link) const
{
    if (isMet(link))
        return poleOf(clearance(link), size_);
    SmoothMinimum minimum(linkRadius_);
    visitWays(link, edges_, [&minimum](const Vector2d &apart, double fraction) { minimum.add(apart, fraction); });
    return poleOf(minimum.positive() ? minimum.value() : clearance(link), size_);
}
}  // namespace narrows
