// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "kernel/SpatialDistance.h"
#include "validity/FclLinkChecker.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

struct SolidOf
{
    double range;  ///< nothing further from the origin matters

    FclSolid operator()(const Sphere &sphere) const
    {
        return {std::make_shared<fcl::Sphered>(sphere.radius), Isometry3d(Eigen::Translation3d(sphere.center)),
                spatialBounds(sphere), sphere.center};
    }

    FclSolid operator()(const Capsule &capsule) const { return fclCapsule(capsule.from, capsule.to, capsule.radius); }

    /// Of a cylinder without ends, as much as the arm can reach.
    FclSolid operator()(Cylinder cylinder) const
    {
        const SpatialBounds box = spatialBounds(cylinder);
        if (std::isinf(cylinder.halfLength))
        {
            cylinder.center -= cylinder.axis.dot(cylinder.center) * cylinder.axis;
            cylinder.halfLength = 1.01 * range + cylinder.radius;
        }
        const Vector3d across = perpendicular(cylinder.axis);
        Isometry3d pose = Isometry3d::Identity();
        pose.linear() << across, cylinder.axis.cross(across), cylinder.axis;
        pose.translation() = cylinder.center;
        return {std::make_shared<fcl::Cylinderd>(cylinder.radius, 2.0 * cylinder.halfLength), pose, box,
                cylinder.center};
    }

    FclSolid operator()(const Box &box) const
    {
        return {std::make_shared<fcl::Boxd>(2.0 * box.halfExtents), box.pose, spatialBounds(box),
                box.pose.translation()};
    }

    /// Of a prism without ends, as much as the arm can reach.
    FclSolid operator()(Prism prism) const
    {
        const SpatialBounds box = spatialBounds(prism);
        if (std::isinf(prism.halfLength))
        {
            double width = 0.0;
            for (const Eigen::Vector2d &vertex : prism.vertices)
                width = std::max(width, vertex.norm());
            prism.pose.translation() -= prism.axis().dot(prism.pose.translation()) * prism.axis();
            prism.halfLength = 1.01 * range + width;
        }
        const int count = static_cast<int>(prism.vertices.size());
        const auto corners = std::make_shared<std::vector<Vector3d>>();
        const auto faces = std::make_shared<std::vector<int>>();
        for (const double height : {-prism.halfLength, prism.halfLength})
            for (const Eigen::Vector2d &vertex : prism.vertices)
                corners->push_back({vertex.x(), vertex.y(), height});
        faces->push_back(count);
        for (int i = 0; i < count; ++i)
            faces->push_back(count - 1 - i);
        faces->push_back(count);
        for (int i = 0; i < count; ++i)
            faces->push_back(count + i);
        for (int i = 0, next = 1; i < count; ++i, next = (i + 1) % count)
            faces->insert(faces->end(), {4, i, next, count + next, count + i});
        const Vector3d anchor = prism.pose * corners->front();
        return {std::make_shared<fcl::Convexd>(corners, count + 2, faces), prism.pose, box, anchor};
    }

    FclSolid operator()(const Mesh &mesh) const
    {
        auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
        model->beginModel();
        for (const std::array<int, 3> &triangle : mesh.triangles)
            model->addTriangle(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
        model->endModel();
        return {model, Isometry3d::Identity(), spatialBounds(mesh), mesh.vertices[mesh.triangles[0][0]]};
    }
};
}  // namespace

std::unique_ptr<SpatialChecker> makeFclChecker(const SpatialModel &model)
{
    const SolidOf solidOf{farthestFromOrigin(model.arm)};
    std::vector<FclObstacle> obstacles;
    for (const SpatialObstacle &obstacle : model.obstacles)
    {
        obstacles.push_back({std::visit(solidOf, obstacle.shape), {}});
        if (const auto *mesh = std::get_if<Mesh>(&obstacle.shape))
            obstacles.back().mesh.emplace(*mesh);
    }
    return std::make_unique<FclLinkChecker<3>>(std::move(obstacles));
}
}  // namespace narrows
