// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SegmentDistance.h"
#include "kernel/SuperellipseGeometry.h"
#include "validity/ArmChecker.h"

namespace narrows
{
/// What the analytic checker for planar arms was before it learned to look at many things at once: the standard
/// library's sine and cosine, one link and one obstacle after the other. The reference of its verdicts and of its
/// speed.
class ScalarChecker
{
public:
    explicit ScalarChecker(const PlanarModel &model) : model_(model)
    {
        for (const PlanarObstacle &obstacle : model.obstacles)
            if (const auto *shape = std::get_if<Superellipse>(&obstacle.shape))
                superellipses_.push_back({bounds(obstacle), SuperellipseGeometry(*shape)});
            else if (const auto *circle = std::get_if<Circle>(&obstacle.shape))
                circles_.push_back({bounds(obstacle), *circle});
            else
                polygons_.push_back({bounds(obstacle), std::get<Polygon>(obstacle.shape)});
    }

    bool isFree(ConfigurationRef q) const
    {
        place(q);
        for (int i = 0; i < model_.arm.linkCount(); ++i)
            if (!clears(points_[model_.arm.links()[i].parent + 1], points_[i + 1]))
                return false;
        for (int i = 0; model_.selfCollision && i < model_.arm.linkCount(); ++i)
            for (int j = 0; j < i; ++j)
                if (!model_.arm.areNeighbours(i, j) && collide(i, j))
                    return false;
        return true;
    }

private:
    template <class Shape>
    struct Boxed
    {
        Bounds box;
        Shape shape;
    };

    void place(ConfigurationRef q) const
    {
        const PlanarArm &arm = model_.arm;
        points_.resize(arm.links().size() + 1);
        points_[0] = arm.base();
        if (arm.slide())
            points_[0] += q[0] * arm.slide()->axis;
        for (int i = 0; i < arm.linkCount(); ++i)
        {
            const double angle = q[arm.firstAngle() + i];
            const double cosine = std::cos(angle), sine = std::sin(angle);
            const auto &[length, parent] = arm.links()[i];
            points_[i + 1] = points_[parent + 1] + length * Eigen::Vector2d(cosine, sine);
        }
    }

    bool clears(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const
    {
        const double radius = model_.arm.radius();
        const Eigen::Vector2d lower = a.cwiseMin(b).array() - radius, upper = a.cwiseMax(b).array() + radius;
        const auto meets = [&](const Bounds &box)
        {
            return lower.x() <= box.upper.x() && box.lower.x() <= upper.x() && lower.y() <= box.upper.y() &&
                   box.lower.y() <= upper.y();
        };
        for (const auto &[box, circle] : circles_)
        {
            const double contact = circle.radius + radius;
            if (meets(box) && squaredDistance(a, b, circle.center) <= contact * contact)
                return false;
        }
        for (const auto &[box, shape] : superellipses_)
            if (meets(box) && !shape.farther(a, b, radius))
                return false;
        for (const auto &[box, polygon] : polygons_)
            if (meets(box) && distance(a, b, polygon) <= radius)
                return false;
        return true;
    }

    bool collide(int i, int j) const
    {
        const auto base = [&](int link)
        {
            return points_[model_.arm.links()[link].parent + 1];
        };
        return distance(base(i), points_[i + 1], base(j), points_[j + 1]) <= 2.0 * model_.arm.radius();
    }

    PlanarModel model_;
    std::vector<Boxed<Circle>> circles_;
    std::vector<Boxed<SuperellipseGeometry>> superellipses_;
    std::vector<Boxed<Polygon>> polygons_;
    mutable std::vector<Eigen::Vector2d> points_;
};
}  // namespace narrows
