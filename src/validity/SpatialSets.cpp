// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "validity/ConvexSets.h"
#include "validity/MeshParts.h"

namespace narrows::proof
{
namespace
{
using Eigen::Vector3d;

ConvexSet<3> between(const Vector3d &from, const Vector3d &to, double inflation)
{
    return {Segment<3>{from, to}, inflation, 0.5 * (from + to), 0.5 * (to - from).norm()};
}

struct AddParts
{
    Parts<3> &parts;
    const std::string &name;
    int obstacle;
    double extent;

    void operator()(const Sphere &ball) const { parts.add(between(ball.center, ball.center, ball.radius), obstacle); }

    void operator()(const Capsule &capsule) const
    {
        parts.add(between(capsule.from, capsule.to, capsule.radius), obstacle);
    }

    /// Without ends it is a capsule whose ends are out of reach.
    void operator()(const Cylinder &cylinder) const
    {
        if (std::isfinite(cylinder.halfLength))
        {
            parts.add({cylinder, 0.0, cylinder.center, std::hypot(cylinder.radius, cylinder.halfLength)}, obstacle);
            return;
        }
        const Vector3d nearOrigin = cylinder.center - cylinder.center.dot(cylinder.axis) * cylinder.axis;
        const Vector3d way = extent * cylinder.axis;
        parts.add(between(nearOrigin - way, nearOrigin + way, cylinder.radius), obstacle);
    }

    void operator()(const Box &box) const
    {
        parts.add({box, 0.0, box.pose.translation(), box.halfExtents.norm()}, obstacle);
    }

    /// Without ends it is one whose ends are out of reach.
    void operator()(Prism prism) const
    {
        if (std::isinf(prism.halfLength))
        {
            prism.pose.translation() -= prism.pose.translation().dot(prism.axis()) * prism.axis();
            prism.halfLength = extent;
        }
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d &vertex : prism.vertices)
            middle += vertex / static_cast<double>(prism.vertices.size());
        double radius = 0.0;
        for (const Eigen::Vector2d &vertex : prism.vertices)
            radius = std::max(radius, (vertex - middle).norm());
        const Vector3d center = prism.pose * Vector3d(middle.x(), middle.y(), 0.0);
        parts.add({prism, 0.0, center, std::hypot(radius, prism.halfLength)}, obstacle);
    }

    void operator()(const Mesh &mesh) const
    {
        if (mesh.closed && !isClosed(mesh))
            throw std::invalid_argument("the mesh " + name +
                                        " is not closed, or its triangles are not all turned the same way");
        addTriangles(mesh, obstacle, parts);
    }
};
}  // namespace

Parts<3> partsOf(const std::vector<SpatialObstacle> &obstacles, double extent)
{
    Parts<3> parts;
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        std::visit(AddParts{parts, obstacles[i].name, static_cast<int>(i), extent}, obstacles[i].shape);
    return parts;
}

bool encloses(const SpatialObstacle &obstacle, const Vector3d &point)
{
    const auto *mesh = std::get_if<Mesh>(&obstacle.shape);
    return mesh && mesh->closed && std::abs(turnsAround(*mesh, point)) > 0.5;
}
}  // namespace narrows::proof
