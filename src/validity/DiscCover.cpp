// SPDX-License-Identifier: BSD-3-Clause
#include "validity/DiscCover.h"

#include <cmath>

#include "kernel/SegmentDistance.h"
#include "kernel/SuperellipseGeometry.h"

namespace narrows
{
namespace
{
struct Covers
{
    const Eigen::Vector2d &center;
    double radius;

    bool operator()(const Circle &circle) const { return (center - circle.center).norm() + radius <= circle.radius; }

    /// A convex shape that holds the corners of a polygon around the disc holds the disc.
    bool operator()(const Superellipse &shape) const
    {
        constexpr int corners = 16;
        const SuperellipseGeometry geometry(shape);
        const double distance = radius / std::cos(M_PI / corners);
        for (int i = 0; i < corners; ++i)
        {
            const double angle = 2.0 * M_PI * i / corners;
            if (geometry.value(center + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle))) > 0.0)
                return false;
        }
        return true;
    }

    bool operator()(const Polygon &polygon) const
    {
        const std::vector<Eigen::Vector2d> &v = polygon.vertices;
        for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
            if (squaredDistance(v[j], v[i], center) < radius * radius)
                return false;
        return contains(polygon, center);
    }
};
}  // namespace

bool coversDisc(const PlanarObstacle &obstacle, const Eigen::Vector2d &center, double radius)
{
    return std::visit(Covers{center, radius}, obstacle.shape);
}
}  // namespace narrows
