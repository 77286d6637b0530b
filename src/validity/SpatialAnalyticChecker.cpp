// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "kernel/SpatialBounds.h"
#include "validity/SpatialCertificates.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

struct DistanceFrom
{
    const Link<3> &link;

    template <class Convex>
    double operator()(const Convex &shape) const
    {
        return nearness(link.a, link.b, shape).distance;
    }
    double operator()(const MeshGeometry &mesh) const { return mesh.nearest(link.a, link.b).distance; }
};

struct IsClearOf
{
    const Link<3> &link;

    template <class Convex>
    bool operator()(const Convex &shape) const
    {
        return nearness(link.a, link.b, shape).distance > link.radius;
    }
    bool operator()(const MeshGeometry &mesh) const { return mesh.keepsAway(link.a, link.b, link.radius); }
};

class AnalyticChecker final : public SpatialChecker
{
public:
    explicit AnalyticChecker(const std::vector<SpatialObstacle> &obstacles)
    {
        for (const SpatialObstacle &obstacle : obstacles)
            obstacles_.push_back({spatialBounds(obstacle), prepared(obstacle.shape)});
    }

    bool clears(const Link<3> &link) const override
    {
        const SpatialBounds box = boundsAround(link.a, link.b, link.radius);
        return std::all_of(obstacles_.begin(), obstacles_.end(),
                           [&](const Obstacle &obstacle)
                           { return !box.meets(obstacle.box) || std::visit(IsClearOf{link}, obstacle.shape); });
    }

    double clearance(const Link<3> &link) const override
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Obstacle &obstacle : obstacles_)
            least = std::min(least, std::visit(DistanceFrom{link}, obstacle.shape));
        return least - link.radius;
    }

    Finding examine(const LinkMotion<3> &link) const override
    {
        const double reach = link.reach();
        const SpatialBounds box = boundsAround(link.a.position, link.b.position, link.radius + reach);
        Finding worst = Finding::Clear;
        for (const Obstacle &obstacle : obstacles_)
        {
            if (box.meets(obstacle.box))
                worst =
                    std::max(worst, std::visit([&](const auto &shape) { return narrows::examine(link, reach, shape); },
                                               obstacle.shape));
            if (worst == Finding::Touching)
                break;
        }
        return worst;
    }

    bool clears(const Link<3> &link, const Link<3> &other) const override { return clearance(link, other) > 0.0; }

    double clearance(const Link<3> &link, const Link<3> &other) const override
    {
        return nearness(link.a, link.b, Capsule{other.a, other.b, other.radius}).distance - link.radius;
    }

    Finding examine(const LinkMotion<3> &link, const LinkMotion<3> &other) const override
    {
        return narrows::examine(link, other, link.reach() + other.reach());
    }

private:
    using Shape = std::variant<Sphere, Capsule, Cylinder, Box, Prism, MeshGeometry>;

    struct Obstacle
    {
        SpatialBounds box;
        Shape shape;
    };

    struct Prepare
    {
        Shape operator()(const Mesh &mesh) const { return MeshGeometry(mesh); }
        template <class Convex>
        Shape operator()(const Convex &shape) const
        {
            return shape;
        }
    };

    static Shape prepared(const decltype(SpatialObstacle::shape) &shape) { return std::visit(Prepare{}, shape); }

    std::vector<Obstacle> obstacles_;
};
}  // namespace

std::unique_ptr<SpatialChecker> makeAnalyticChecker(const SpatialModel &model)
{
    return std::make_unique<AnalyticChecker>(model.obstacles);
}
}  // namespace narrows
