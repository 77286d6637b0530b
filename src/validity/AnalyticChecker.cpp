// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/SegmentDistance.h"
#include "kernel/SuperellipseGeometry.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

class AnalyticChecker : public PlanarChecker
{
public:
    explicit AnalyticChecker(const PlanarModel &model) : radius_(model.arm.radius())
    {
        for (const PlanarObstacle &obstacle : model.obstacles)
            std::visit([&](const auto &shape) { add(shape, bounds(obstacle)); }, obstacle.shape);
    }

    bool linkClears(const Vector2d &a, const Vector2d &b, double margin) const override
    {
        const double room = radius_ + margin;
        const Box link{std::min(a.x(), b.x()) - room, std::min(a.y(), b.y()) - room, std::max(a.x(), b.x()) + room,
                       std::max(a.y(), b.y()) + room};
        for (std::size_t i = 0; i < circles_.size(); ++i)
            if (link.meets(circleBoxes_[i]))
            {
                const double reach = circles_[i].radius + room;
                if (squaredDistance(a, b, circles_[i].center) <= reach * reach)
                    return false;
            }
        for (std::size_t i = 0; i < superellipses_.size(); ++i)
            if (link.meets(superellipseBoxes_[i]) && !superellipses_[i].farther(a, b, room))
                return false;
        for (std::size_t i = 0; i < polygons_.size(); ++i)
            if (link.meets(polygonBoxes_[i]) && !(distance(a, b, polygons_[i]) > room))
                return false;
        return true;
    }

    double linkClearance(const Vector2d &a, const Vector2d &b) const override
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Circle &circle : circles_)
            nearest = std::min(nearest, std::sqrt(squaredDistance(a, b, circle.center)) - circle.radius);
        for (const SuperellipseGeometry &shape : superellipses_)
            nearest = std::min(nearest, shape.distance(a, b));
        for (const Polygon &polygon : polygons_)
            nearest = std::min(nearest, distance(a, b, polygon));
        return nearest - radius_;
    }

private:
    struct Box
    {
        double left, bottom, right, top;
        bool meets(const Box &other) const
        {
            return left <= other.right && other.left <= right && bottom <= other.top && other.bottom <= top;
        }
    };

    void add(const Circle &circle, const Bounds &box)
    {
        circles_.push_back(circle);
        circleBoxes_.push_back({box.lower.x(), box.lower.y(), box.upper.x(), box.upper.y()});
    }

    void add(const Superellipse &shape, const Bounds &box)
    {
        superellipses_.emplace_back(shape);
        superellipseBoxes_.push_back({box.lower.x(), box.lower.y(), box.upper.x(), box.upper.y()});
    }

    void add(const Polygon &polygon, const Bounds &box)
    {
        polygons_.push_back(polygon);
        polygonBoxes_.push_back({box.lower.x(), box.lower.y(), box.upper.x(), box.upper.y()});
    }

    // By kind, so that the loops stay tight: a state is checked in tens of nanoseconds.
    double radius_;
    std::vector<Circle> circles_;
    std::vector<Box> circleBoxes_;
    std::vector<SuperellipseGeometry> superellipses_;
    std::vector<Box> superellipseBoxes_;
    std::vector<Polygon> polygons_;
    std::vector<Box> polygonBoxes_;
};
}  // namespace

std::unique_ptr<PlanarChecker> makeAnalyticChecker(const PlanarModel &model)
{
    return std::make_unique<AnalyticChecker>(model);
}
}  // namespace narrows
