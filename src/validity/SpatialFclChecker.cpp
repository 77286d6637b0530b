// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "kernel/MeshGeometry.h"
#include "kernel/SpatialDistance.h"
#include "validity/FclSolid.h"
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

class FclChecker final : public SpatialChecker
{
public:
    explicit FclChecker(const SpatialModel &model)
    {
        const SolidOf solidOf{farthest(model.arm)};
        for (const SpatialObstacle &obstacle : model.obstacles)
        {
            obstacles_.push_back({std::visit(solidOf, obstacle.shape), {}});
            if (const auto *mesh = std::get_if<Mesh>(&obstacle.shape))
                obstacles_.back().inside.emplace(*mesh);
        }
    }

    bool clears(const Link<3> &link) const override
    {
        const FclSegment segment(link.a, link.b);
        return std::all_of(obstacles_.begin(), obstacles_.end(),
                           [&](const Obstacle &obstacle)
                           { return examine(segment, link.a, obstacle, link.radius, 0.0) == Finding::Clear; });
    }

    double clearance(const Link<3> &link) const override
    {
        const FclSegment segment(link.a, link.b);
        constexpr double far = std::numeric_limits<double>::infinity();
        double least = far;
        for (const Obstacle &obstacle : obstacles_)
        {
            if (obstacle.contains(link.a))
                return 0.0;
            if (segment.boxDistance(obstacle.solid) - link.radius < least &&
                !(least < far && segment.clears(obstacle.solid, link.radius + least)))
                least = std::min(least, segment.clearance(obstacle.solid, link.radius));
        }
        return least;
    }

    Finding examine(const LinkMotion<3> &link) const override
    {
        const FclSegment segment(link.a.position, link.b.position);
        const double reach = link.reach();
        Finding worst = Finding::Clear;
        for (const Obstacle &obstacle : obstacles_)
        {
            worst = std::max(worst, examine(segment, link.a.position, obstacle, link.radius, reach));
            if (worst == Finding::Touching)
                break;
        }
        return worst;
    }

    bool clears(const Link<3> &link, const Link<3> &other) const override
    {
        return FclSegment(link.a, link.b).clears(fclCapsule(other.a, other.b, other.radius), link.radius);
    }

    double clearance(const Link<3> &link, const Link<3> &other) const override
    {
        return FclSegment(link.a, link.b).clearance(fclCapsule(other.a, other.b, other.radius), link.radius);
    }

    Finding examine(const LinkMotion<3> &link, const LinkMotion<3> &other) const override
    {
        const Obstacle capsule{fclCapsule(other.a.position, other.b.position, other.radius), {}};
        return examine(FclSegment(link.a.position, link.b.position), link.a.position, capsule, link.radius,
                       link.reach() + other.reach());
    }

private:
    struct Obstacle
    {
        FclSolid solid;
        std::optional<MeshGeometry> inside;  ///< FCL's meshes are surfaces only

        bool contains(const Vector3d &point) const { return inside && inside->contains(point); }
    };

    /// To first order only: a library that answers yes or no has no plane to show.
    static Finding examine(const FclSegment &segment, const Vector3d &end, const Obstacle &obstacle, double radius,
                           double reach)
    {
        if (segment.boxDistance(obstacle.solid) > radius + reach)
            return Finding::Clear;
        if (obstacle.contains(end))
            return Finding::Touching;
        if (segment.clears(obstacle.solid, radius + reach))
            return Finding::Clear;
        return segment.clears(obstacle.solid, radius) ? Finding::Unsure : Finding::Touching;
    }

    std::vector<Obstacle> obstacles_;
};
}  // namespace

std::unique_ptr<SpatialChecker> makeFclChecker(const SpatialModel &model)
{
    return std::make_unique<FclChecker>(model);
}
}  // namespace narrows
