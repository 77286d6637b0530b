// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "validity/CircumscribedPolygon.h"
#include "validity/ConvexPieces.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// FCL's yes-or-no query with its default solver (libccd) misses overlaps of less than its tolerance of 1e-6 and
/// nothing else, so capsules this much thicker err on the safe side only; links without a radius get a robust one by
/// the way. Its other solver misses deep overlaps, and distances of both are now and then far off:
/// tests/FclCheckerTest.cpp.
constexpr double resolution = 1e-6;

constexpr double superellipseTolerance = 1e-3;  // of the smaller half extent

/// An obstacle, or a convex piece of it, as a solid that the plane z = 0 cuts in the obstacle. The links lie in that
/// plane, and every solid is symmetric about it, so distances in space are those in the plane.
struct Solid
{
    std::shared_ptr<const fcl::CollisionGeometryd> geometry;
    fcl::Transform3d pose;
    Bounds box;
    Vector2d anchor;  ///< some point of the obstacle
};

fcl::Transform3d shifted(const Vector2d &to)
{
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation() << to.x(), to.y(), 0.0;
    return pose;
}

/// Half the height of extrusions: about as much as they are wide, which suits the solver.
double halfHeight(const Bounds &box)
{
    return 0.5 * (box.upper - box.lower).norm();
}

bool isAxisParallelBox(const Polygon &polygon, const Bounds &box)
{
    if (polygon.vertices.size() != 4)
        return false;
    return std::all_of(polygon.vertices.begin(), polygon.vertices.end(),
                       [&](const Vector2d &vertex)
                       {
                           return (vertex.x() == box.lower.x() || vertex.x() == box.upper.x()) &&
                                  (vertex.y() == box.lower.y() || vertex.y() == box.upper.y());
                       });
}

std::shared_ptr<fcl::Convexd> extrude(const Polygon &polygon, double height)
{
    const int n = static_cast<int>(polygon.vertices.size());
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const double z : {-height, height})
        for (const Vector2d &vertex : polygon.vertices)
            vertices->emplace_back(vertex.x(), vertex.y(), z);
    auto faces = std::make_shared<std::vector<int>>();
    faces->push_back(n);
    for (int i = n - 1; i >= 0; --i)
        faces->push_back(i);
    faces->push_back(n);
    for (int i = 0; i < n; ++i)
        faces->push_back(n + i);
    for (int i = 0; i < n; ++i)
    {
        const int next = (i + 1) % n;
        faces->insert(faces->end(), {4, i, next, n + next, n + i});
    }
    return std::make_shared<fcl::Convexd>(vertices, n + 2, faces, true);
}

Solid convexSolid(const Polygon &polygon)
{
    const Bounds box = bounds({"", polygon});
    const double height = halfHeight(box);
    if (!isAxisParallelBox(polygon, box))
        return {extrude(polygon, height), fcl::Transform3d::Identity(), box, polygon.vertices.front()};
    const Vector2d size = box.upper - box.lower;
    return {std::make_shared<fcl::Boxd>(size.x(), size.y(), 2.0 * height), shifted(0.5 * (box.lower + box.upper)), box,
            polygon.vertices.front()};
}

struct SolidsOf
{
    /// A ball rather than a cylinder: FCL answers ball against capsule in closed form, exact and robust.
    std::vector<Solid> operator()(const Circle &circle) const
    {
        return {{std::make_shared<fcl::Sphered>(circle.radius), shifted(circle.center), bounds({"", circle}),
                 circle.center}};
    }

    std::vector<Solid> operator()(const Superellipse &shape) const
    {
        return {convexSolid(circumscribedPolygon(shape, superellipseTolerance))};
    }

    std::vector<Solid> operator()(const Polygon &polygon) const
    {
        std::vector<Solid> solids;
        for (const Polygon &piece : convexPieces(polygon))
            solids.push_back(convexSolid(piece));
        return solids;
    }
};

/// The pose of a capsule around the segment ab: FCL's capsules stand along z.
fcl::Transform3d capsulePose(const Vector2d &a, const Vector2d &b)
{
    fcl::Transform3d pose = shifted(0.5 * (a + b));
    const double length = (b - a).norm();
    const Vector2d along = length > 0.0 ? Vector2d((b - a) / length) : Vector2d(1.0, 0.0);
    pose.linear().col(0) << -along.y(), along.x(), 0.0;
    pose.linear().col(1) << 0.0, 0.0, 1.0;
    pose.linear().col(2) << along.x(), along.y(), 0.0;
    return pose;
}

/// A link as something that another link may touch.
Solid solidLink(const Link<2> &link)
{
    const Vector2d room = Vector2d::Constant(link.radius);
    return {std::make_shared<fcl::Capsuled>(link.radius + resolution, (link.b - link.a).norm()),
            capsulePose(link.a, link.b),
            {link.a.cwiseMin(link.b) - room, link.a.cwiseMax(link.b) + room},
            link.a};
}

/// A link as a capsule whose radius is still open.
class Capsule
{
public:
    Capsule(const Vector2d &a, const Vector2d &b)
      : a_(a), length_((b - a).norm()), lower_(a.cwiseMin(b)), upper_(a.cwiseMax(b)), pose_(capsulePose(a, b))
    {
    }

    /// No greater than the distance to the solid.
    double boxDistance(const Solid &solid) const
    {
        return (solid.box.lower - upper_).cwiseMax(lower_ - solid.box.upper).cwiseMax(0.0).norm();
    }

    /// No less than the distance to the solid.
    double anchorDistance(const Solid &solid) const { return (solid.anchor - a_).norm(); }

    /// Whether the solid keeps away from the segment by more than the distance. Errs, by less than twice the
    /// resolution, towards "no"; whatever makes FCL throw counts as "no" too.
    bool clears(const Solid &solid, double distance) const
    {
        const fcl::Capsuled capsule(distance + resolution, length_);
        const fcl::CollisionRequestd request;
        fcl::CollisionResultd result;
        try
        {
            return fcl::collide(&capsule, pose_, solid.geometry.get(), solid.pose, request, result) == 0;
        }
        catch (const std::exception &)
        {
            return false;
        }
    }

    /// FCL's answer, right most of the time; NaN if it throws.
    double claimedDistance(const Solid &solid) const
    {
        const fcl::Capsuled capsule(resolution, length_);
        const fcl::DistanceRequestd request;
        fcl::DistanceResultd result;
        try
        {
            return fcl::distance(&capsule, pose_, solid.geometry.get(), solid.pose, request, result) + resolution;
        }
        catch (const std::exception &)
        {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

private:
    Vector2d a_;
    double length_;
    Vector2d lower_, upper_;
    fcl::Transform3d pose_;
};

class FclChecker final : public PlanarChecker
{
public:
    explicit FclChecker(const std::vector<PlanarObstacle> &obstacles)
    {
        for (const PlanarObstacle &obstacle : obstacles)
            for (Solid &solid : std::visit(SolidsOf{}, obstacle.shape))
                solids_.push_back(std::move(solid));
    }

    bool clears(const Link<2> &link) const override
    {
        const Capsule capsule(link.a, link.b);
        return std::all_of(solids_.begin(), solids_.end(),
                           [&](const Solid &solid)
                           { return capsule.boxDistance(solid) > link.radius || capsule.clears(solid, link.radius); });
    }

    double clearance(const Link<2> &link) const override
    {
        const Capsule capsule(link.a, link.b);
        constexpr double far = std::numeric_limits<double>::infinity();
        double least = far;
        for (const Solid &solid : solids_)
            if (capsule.boxDistance(solid) - link.radius < least &&
                !(least < far && capsule.clears(solid, link.radius + least)))
                least = std::min(least, clearance(capsule, solid, link.radius));
        return least;
    }

    Finding examine(const LinkMotion<2> &link) const override
    {
        const double reach = link.reach();
        const Capsule capsule(link.a.position, link.b.position);
        Finding worst = Finding::Clear;
        for (const Solid &solid : solids_)
        {
            if (capsule.boxDistance(solid) > link.radius + reach)
                continue;
            worst = std::max(worst, examine(capsule, solid, link.radius, reach));
            if (worst == Finding::Touching)
                break;
        }
        return worst;
    }

    bool clears(const Link<2> &link, const Link<2> &other) const override
    {
        return Capsule(link.a, link.b).clears(solidLink(other), link.radius);
    }

    double clearance(const Link<2> &link, const Link<2> &other) const override
    {
        return clearance(Capsule(link.a, link.b), solidLink(other), link.radius);
    }

    Finding examine(const LinkMotion<2> &link, const LinkMotion<2> &other) const override
    {
        const Solid solid = solidLink({other.a.position, other.b.position, other.radius});
        const double reach = link.reach() + other.reach();
        const Capsule capsule(link.a.position, link.b.position);
        if (capsule.boxDistance(solid) > link.radius + reach)
            return Finding::Clear;
        return examine(capsule, solid, link.radius, reach);
    }

private:
    static Finding examine(const Capsule &capsule, const Solid &solid, double radius, double reach)
    {
        if (capsule.clears(solid, radius + reach))
            return Finding::Clear;
        return capsule.clears(solid, radius) ? Finding::Unsure : Finding::Touching;
    }

    /// A distance that FCL claims is believed only if its yes-or-no query confirms it from both sides; else the latter
    /// finds it alone, by bisection.
    static double clearance(const Capsule &capsule, const Solid &solid, double radius)
    {
        if (!capsule.clears(solid, radius))
            return 0.0;
        double low = radius, high = std::max(capsule.anchorDistance(solid), radius + resolution);
        const double claimed = capsule.claimedDistance(solid);
        if (claimed - 4.0 * resolution > low && capsule.clears(solid, claimed - 4.0 * resolution))
            low = claimed - 4.0 * resolution;
        if (claimed + 4.0 * resolution < high && !capsule.clears(solid, claimed + 4.0 * resolution))
            high = claimed + 4.0 * resolution;
        while (high - low > 10.0 * resolution)
        {
            const double middle = 0.5 * (low + high);
            (capsule.clears(solid, middle) ? low : high) = middle;
        }
        return std::max(low - radius, 0.01 * resolution);
    }

    std::vector<Solid> solids_;
};
}  // namespace

std::unique_ptr<PlanarChecker> makeFclChecker(const PlanarModel &model)
{
    return std::make_unique<FclChecker>(model.obstacles);
}
}  // namespace narrows
