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

/// A link as a capsule whose radius is still open.
class Link
{
public:
    Link(const Vector2d &a, const Vector2d &b)
      : a_(a), length_((b - a).norm()), lower_(a.cwiseMin(b)), upper_(a.cwiseMax(b)), pose_(shifted(0.5 * (a + b)))
    {
        // FCL's capsules stand along z.
        const Vector2d along = length_ > 0.0 ? Vector2d((b - a) / length_) : Vector2d(1.0, 0.0);
        pose_.linear().col(0) << -along.y(), along.x(), 0.0;
        pose_.linear().col(1) << 0.0, 0.0, 1.0;
        pose_.linear().col(2) << along.x(), along.y(), 0.0;
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
    explicit FclChecker(const PlanarModel &model) : radius_(model.arm.radius())
    {
        for (const PlanarObstacle &obstacle : model.obstacles)
            for (Solid &solid : std::visit(SolidsOf{}, obstacle.shape))
                solids_.push_back(std::move(solid));
    }

    bool linkClears(const Vector2d &a, const Vector2d &b, double margin) const override
    {
        const Link link(a, b);
        const double needed = radius_ + margin;
        return std::all_of(solids_.begin(), solids_.end(),
                           [&](const Solid &solid)
                           { return link.boxDistance(solid) > needed || link.clears(solid, needed); });
    }

    double linkClearance(const Vector2d &a, const Vector2d &b) const override
    {
        const Link link(a, b);
        constexpr double far = std::numeric_limits<double>::infinity();
        double least = far;
        for (const Solid &solid : solids_)
            if (link.boxDistance(solid) - radius_ < least && !(least < far && link.clears(solid, radius_ + least)))
                least = std::min(least, clearance(link, solid));
        return least;
    }

private:
    /// A distance that FCL claims is believed only if its yes-or-no query confirms it from both sides; else the latter
    /// finds it alone, by bisection.
    double clearance(const Link &link, const Solid &solid) const
    {
        if (!link.clears(solid, radius_))
            return 0.0;
        double low = radius_, high = std::max(link.anchorDistance(solid), radius_ + resolution);
        const double claimed = link.claimedDistance(solid);
        if (claimed - 4.0 * resolution > low && link.clears(solid, claimed - 4.0 * resolution))
            low = claimed - 4.0 * resolution;
        if (claimed + 4.0 * resolution < high && !link.clears(solid, claimed + 4.0 * resolution))
            high = claimed + 4.0 * resolution;
        while (high - low > 10.0 * resolution)
        {
            const double middle = 0.5 * (low + high);
            (link.clears(solid, middle) ? low : high) = middle;
        }
        return std::max(low - radius_, 0.01 * resolution);
    }

    double radius_;
    std::vector<Solid> solids_;
};
}  // namespace

std::unique_ptr<PlanarChecker> makeFclChecker(const PlanarModel &model)
{
    return std::make_unique<FclChecker>(model);
}
}  // namespace narrows
