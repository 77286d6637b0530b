// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
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

/// How far from the origin any point of the arm can be.
double farthest(const SpatialArm &arm)
{
    double distance = 0.0;
    for (const SpatialJoint &joint : arm.joints())
        if (joint.parent < 0)
            distance = std::max(distance, joint.offset.translation().norm() + arm.reach());
    for (const SpatialLink &link : arm.links())
        if (link.joint < 0)
            distance = std::max(distance, std::max(link.from.norm(), link.to.norm()) + link.radius);
    return distance;
}

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
    const SolidOf solidOf{farthest(model.arm)};
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
