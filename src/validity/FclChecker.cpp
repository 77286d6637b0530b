// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <utility>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>

#include "validity/CircumscribedPolygon.h"
#include "validity/ConvexPieces.h"
#include "validity/FclLinkChecker.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr double superellipseTolerance = 1e-3;  // of the smaller half extent

/// An obstacle, or a convex piece of it, as a solid that the plane z = 0 cuts in the obstacle. The links lie in that
/// plane, and every solid is symmetric about it, so distances in space are those in the plane.
FclObstacle inPlane(std::shared_ptr<const fcl::CollisionGeometryd> geometry, const Vector2d &center, const Bounds &box,
                    const Vector2d &anchor)
{
    const auto lifted = [](const Vector2d &point)
    {
        return Eigen::Vector3d(point.x(), point.y(), 0.0);
    };
    return {{std::move(geometry),
             Eigen::Isometry3d(Eigen::Translation3d(lifted(center))),
             {lifted(box.lower), lifted(box.upper)},
             lifted(anchor)},
            {}};
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

FclObstacle convexSolid(const Polygon &polygon)
{
    const Bounds box = bounds({"", polygon});
    const double height = halfHeight(box);
    if (!isAxisParallelBox(polygon, box))
        return inPlane(extrude(polygon, height), Vector2d::Zero(), box, polygon.vertices.front());
    const Vector2d size = box.upper - box.lower;
    return inPlane(std::make_shared<fcl::Boxd>(size.x(), size.y(), 2.0 * height), 0.5 * (box.lower + box.upper), box,
                   polygon.vertices.front());
}

struct SolidsOf
{
    /// A ball rather than a cylinder: FCL answers ball against capsule in closed form, exact and robust.
    std::vector<FclObstacle> operator()(const Circle &circle) const
    {
        return {
            inPlane(std::make_shared<fcl::Sphered>(circle.radius), circle.center, bounds({"", circle}), circle.center)};
    }

    std::vector<FclObstacle> operator()(const Superellipse &shape) const
    {
        return {convexSolid(circumscribedPolygon(shape, superellipseTolerance))};
    }

    std::vector<FclObstacle> operator()(const Polygon &polygon) const
    {
        std::vector<FclObstacle> solids;
        for (const Polygon &piece : convexPieces(polygon))
            solids.push_back(convexSolid(piece));
        return solids;
    }
};
}  // namespace

std::unique_ptr<PlanarChecker> makeFclChecker(const PlanarModel &model)
{
    std::vector<FclObstacle> obstacles;
    for (const PlanarObstacle &obstacle : model.obstacles)
        for (FclObstacle &solid : std::visit(SolidsOf{}, obstacle.shape))
            obstacles.push_back(std::move(solid));
    return std::make_unique<FclLinkChecker<2>>(std::move(obstacles));
}
}  // namespace narrows
