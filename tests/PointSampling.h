// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// The dumbest possible collision check, as an oracle: points on links against the defining inequalities of obstacles.
struct ContainsPoint
{
    Eigen::Vector2d point;

    bool operator()(const Circle &circle) const { return (point - circle.center).norm() <= circle.radius; }

    bool operator()(const Superellipse &shape) const
    {
        const Eigen::Vector2d ratio = (point - shape.center).cwiseQuotient(shape.halfExtents).cwiseAbs();
        return std::pow(ratio.x(), shape.exponent) + std::pow(ratio.y(), shape.exponent) <= 1.0;
    }

    /// Winding number by summed angles.
    bool operator()(const Polygon &polygon) const
    {
        double turned = 0.0;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        {
            const Eigen::Vector2d from = polygon.vertices[i] - point;
            const Eigen::Vector2d to = polygon.vertices[(i + 1) % polygon.vertices.size()] - point;
            turned += std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
        }
        return std::abs(turned) > 3.0;
    }
};

/// Whether any of `samples` + 1 points on a link's axis is in an obstacle.
inline bool segmentHits(const std::vector<PlanarObstacle> &obstacles, const Eigen::Vector2d &a,
                        const Eigen::Vector2d &b, int samples)
{
    for (int k = 0; k <= samples; ++k)
        for (const PlanarObstacle &obstacle : obstacles)
            if (std::visit(ContainsPoint{a + (b - a) * (static_cast<double>(k) / samples)}, obstacle.shape))
                return true;
    return false;
}

/// The same for all links of an arm without a slide, at absolute angles.
inline bool armHits(const PlanarModel &model, const Eigen::VectorXd &angles, int samples)
{
    std::vector<Eigen::Vector2d> tips;
    for (int link = 0; link < model.arm.linkCount(); ++link)
    {
        const int parent = model.arm.links()[link].parent;
        const Eigen::Vector2d from = parent < 0 ? model.arm.base() : tips[parent];
        const double length = model.arm.links()[link].length;
        tips.emplace_back(from.x() + length * std::cos(angles[link]), from.y() + length * std::sin(angles[link]));
        if (segmentHits(model.obstacles, from, tips.back(), samples))
            return true;
    }
    return false;
}
}  // namespace narrows
