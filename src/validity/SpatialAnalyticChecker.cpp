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
        boxes_.resize(static_cast<int>(obstacles_.size()));
        for (int k = 0; k < boxes_.count(); ++k)
            boxes_.set(k, obstacles_[k].box.lower, obstacles_[k].box.upper, 0.0);
    }

    void findNear(const BoxArrays<3> &boxes, std::vector<ObstacleBits> &near) const override
    {
        boxes.findMeetings(boxes_, near);
    }

    bool clears(const Link<3> &link, ObstacleBits near) const override
    {
        const SpatialBounds box = boundsAround(link.a, link.b, link.radius);
        for (std::size_t k = 0; k < obstacles_.size(); ++k)
            if (isAmong(near, k) && box.meets(obstacles_[k].box) && !std::visit(IsClearOf{link}, obstacles_[k].shape))
                return false;
        return true;
    }

    double clearance(const Link<3> &link) const override
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Obstacle &obstacle : obstacles_)
            least = std::min(least, std::visit(DistanceFrom{link}, obstacle.shape));
        return least - link.radius;
    }

    Finding examine(const LinkMotion<3> &link, ObstacleBits near) const override
    {
        const double reach = link.reach();
        const SpatialBounds box = boundsAround(link.a.position, link.b.position, link.radius + reach);
        Finding worst = Finding::Clear;
        for (std::size_t k = 0; k < obstacles_.size() && worst != Finding::Touching; ++k)
            if (isAmong(near, k) && box.meets(obstacles_[k].box))
                worst =
                    std::max(worst, std::visit([&](const auto &shape) { return narrows::examine(link, reach, shape); },
                                               obstacles_[k].shape));
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
    BoxArrays<3> boxes_;  ///< theirs
};
}  // namespace

std::unique_ptr<SpatialChecker> makeAnalyticChecker(const SpatialModel &model)
{
    return std::make_unique<AnalyticChecker>(model.obstacles);
}
}  // namespace narrows
