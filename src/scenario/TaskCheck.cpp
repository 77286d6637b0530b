// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/TaskCheck.h"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "kernel/SegmentDistance.h"
#include "kernel/SuperellipseGeometry.h"
#include "scenario/StateCheck.h"

namespace narrows
{
namespace
{
/// Does a shape cover a whole disc?
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

void checkTipGoal(const Field &field, const PlanarModel &model, const TipGoal &goal)
{
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (std::visit(Covers{goal.point, goal.tolerance}, obstacle.shape))
            field.fault(fmt::format("in collision: every point within the tolerance lies inside {}", obstacle.name));
}
}  // namespace

void checkTaskIsFree(const Field &start, const Field &goal, const PlanarModel &model, const PlanarTask &task)
{
    std::vector<int> numbers(model.arm.links().size());
    std::iota(numbers.begin(), numbers.end(), 1);
    checkStateIsFree(start, model, numbers, task.start);
    if (const auto *tip = std::get_if<TipGoal>(&task.goal))
        checkTipGoal(goal, model, *tip);
    else
        checkStateIsFree(goal, model, numbers, std::get<Eigen::VectorXd>(task.goal));
}
}  // namespace narrows
