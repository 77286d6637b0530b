// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "kernel/SegmentDistance.h"
#include "validity/PlanarCertificates.h"
#include "validity/PlanarChecker.h"
#include "validity/Tangents.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

template <class Shape>
struct Boxed
{
    Bounds box;
    Shape shape;
};

struct Edge
{
    Vector2d from, to;
};

/// A polygon's edges, each in its own box.
struct Edges
{
    Polygon polygon;  // for contains()
    std::vector<Boxed<Edge>> edges;
};

struct Rounded
{
    SuperellipseGeometry geometry;
    Tangents tangents;
};

/// What has been found of a link so far, over several obstacles.
class Findings
{
public:
    /// False as soon as nothing can change any more.
    bool add(Finding finding)
    {
        worst_ = std::max(worst_, finding);
        return worst_ != Finding::Touching;
    }
    Finding worst() const { return worst_; }

private:
    Finding worst_ = Finding::Clear;
};

class AnalyticChecker final : public PlanarChecker
{
public:
    explicit AnalyticChecker(const std::vector<PlanarObstacle> &obstacles)
    {
        for (const PlanarObstacle &obstacle : obstacles)
            std::visit([&](const auto &shape) { add(shape, bounds(obstacle)); }, obstacle.shape);
        boxes_.resize(static_cast<int>(obstacles.size()));
        int k = 0;
        forEach(allObstacles,
                [&](const Bounds &box, const auto &) { return boxes_.set(k++, box.lower, box.upper, 0.0), true; });
    }

    void findNear(const BoxArrays<2> &boxes, std::vector<ObstacleBits> &near) const override
    {
        boxes.findMeetings(boxes_, near);
    }

    bool clears(const Link<2> &link, ObstacleBits near) const override
    {
        const Bounds box = Bounds::around(link.a, link.b, link.radius);
        return forEach(near, [&](const Bounds &outer, const auto &shape)
                       { return !box.meets(outer) || !touches(link, box, shape); });
    }

    double clearance(const Link<2> &link) const override
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &[box, circle] : circles_)
            nearest = std::min(nearest, std::sqrt(squaredDistance(link.a, link.b, circle.center)) - circle.radius);
        for (const auto &[box, shape] : superellipses_)
            nearest = std::min(nearest, shape.geometry.distance(link.a, link.b));
        for (const auto &[box, shape] : polygons_)
            nearest = std::min(nearest, distance(link.a, link.b, shape.polygon));
        return nearest - link.radius;
    }

    Finding examine(const LinkMotion<2> &link, ObstacleBits near) const override
    {
        const double reach = link.reach();
        const Bounds box = Bounds::around(link.a.position, link.b.position, link.radius + reach);
        Findings findings;
        forEach(near, [&](const Bounds &outer, const auto &shape)
                { return !box.meets(outer) || findings.add(examine(link, reach, box, shape)); });
        return findings.worst();
    }

    bool clears(const Link<2> &link, const Link<2> &other) const override
    {
        return distance(link.a, link.b, other.a, other.b) > link.radius + other.radius;
    }

    double clearance(const Link<2> &link, const Link<2> &other) const override
    {
        return distance(link.a, link.b, other.a, other.b) - link.radius - other.radius;
    }

    Finding examine(const LinkMotion<2> &link, const LinkMotion<2> &other) const override
    {
        return narrows::examine(link, other, link.reach() + other.reach());
    }

private:
    void add(const Circle &circle, const Bounds &box) { circles_.push_back({box, circle}); }

    void add(const Superellipse &shape, const Bounds &box)
    {
        superellipses_.push_back({box, {SuperellipseGeometry(shape), Tangents(shape)}});
    }

    void add(const Polygon &polygon, const Bounds &box)
    {
        Edges edges{polygon, {}};
        const std::vector<Vector2d> &v = polygon.vertices;
        for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
            edges.edges.push_back({Bounds::around(v[j], v[i]), {v[j], v[i]}});
        polygons_.push_back({box, std::move(edges)});
    }

    /// Calls visit(box, shape) for each obstacle of a set until that returns false, and returns whether none did.
    template <class Visit>
    bool forEach(ObstacleBits near, const Visit &visit) const
    {
        std::size_t k = 0;
        const auto ofOneKind = [&](const auto &obstacles)
        {
            for (const auto &[box, shape] : obstacles)
                if (isAmong(near, k++) && !visit(box, shape))
                    return false;
            return true;
        };
        return ofOneKind(circles_) && ofOneKind(superellipses_) && ofOneKind(polygons_);
    }

    static bool touches(const Link<2> &link, const Bounds & /*box*/, const Circle &circle)
    {
        const double contact = circle.radius + link.radius;
        return squaredDistance(link.a, link.b, circle.center) <= contact * contact;
    }

    static bool touches(const Link<2> &link, const Bounds & /*box*/, const Rounded &shape)
    {
        return !shape.tangents.separate(link.a, link.b, link.radius) &&
               !shape.geometry.farther(link.a, link.b, link.radius);
    }

    static bool touches(const Link<2> &link, const Bounds &box, const Edges &shape)
    {
        if (contains(shape.polygon, link.a))
            return true;
        return std::any_of(
            shape.edges.begin(), shape.edges.end(),
            [&](const Boxed<Edge> &edge)
            { return box.meets(edge.box) && distance(link.a, link.b, edge.shape.from, edge.shape.to) <= link.radius; });
    }

    static Finding examine(const LinkMotion<2> &link, double reach, const Bounds & /*box*/, const Circle &circle)
    {
        return narrows::examine(link, reach, circle);
    }

    static Finding examine(const LinkMotion<2> &link, double reach, const Bounds & /*box*/, const Rounded &shape)
    {
        if (shape.tangents.separate(link.a.position, link.b.position, link.radius + reach))
            return Finding::Clear;
        return narrows::examine(link, reach, shape.geometry);
    }

    /// Outside now, and across no edge until the end of the stretch: outside until then.
    static Finding examine(const LinkMotion<2> &link, double reach, const Bounds &box, const Edges &shape)
    {
        if (contains(shape.polygon, link.a.position))
            return Finding::Touching;
        Findings findings;
        for (const auto &[outer, edge] : shape.edges)
            if (box.meets(outer) && !findings.add(examine(link, reach, edge)))
                break;
        return findings.worst();
    }

    static Finding examine(const LinkMotion<2> &link, double reach, const Edge &edge)
    {
        return narrows::examine(link, {resting<2>(edge.from), resting<2>(edge.to), 0.0, 0.0, link.half}, reach);
    }

    // By kind, so that the loops stay tight: a state is checked in tens of nanoseconds.
    std::vector<Boxed<Circle>> circles_;
    std::vector<Boxed<Rounded>> superellipses_;
    std::vector<Boxed<Edges>> polygons_;
    BoxArrays<2> boxes_;  ///< of all of them, in this order
};
}  // namespace

std::unique_ptr<PlanarChecker> makeAnalyticChecker(const PlanarModel &model)
{
    return std::make_unique<AnalyticChecker>(model.obstacles);
}
}  // namespace narrows
