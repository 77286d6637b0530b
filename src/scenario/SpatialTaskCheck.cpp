// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialTaskCheck.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scenario/StateCheck.h"

namespace narrows
{
namespace
{
/// Does a shape cover a whole ball?
struct Covers
{
    const Eigen::Vector3d &center;
    double radius;

    bool operator()(const Sphere &sphere) const { return (center - sphere.center).norm() + radius <= sphere.radius; }

    bool operator()(const Capsule &capsule) const
    {
        const Eigen::Vector3d along = capsule.to - capsule.from;
        const double t = std::clamp(along.dot(center - capsule.from) / along.squaredNorm(), 0.0, 1.0);
        return (center - capsule.from - t * along).norm() + radius <= capsule.radius;
    }

    bool operator()(const Cylinder &cylinder) const
    {
        const Eigen::Vector3d offset = center - cylinder.center;
        const double height = offset.dot(cylinder.axis);
        return (offset - height * cylinder.axis).norm() + radius <= cylinder.radius &&
               std::abs(height) + radius <= cylinder.halfLength;
    }

    bool operator()(const Box &box) const
    {
        const Eigen::Vector3d inside = box.pose.inverse() * center;
        return (inside.array().abs() + radius <= box.halfExtents.array()).all();
    }

    bool operator()(const Mesh &) const { return false; }
};
}  // namespace

void checkTaskIsFree(const Field &start, const Field &goal, const SpatialModel &model, const SpatialTask &task,
                     const std::vector<int> &numbers)
{
    checkStateIsFree(start, model, numbers, task.start);
    if (const auto *state = std::get_if<Eigen::VectorXd>(&task.goal))
        checkStateIsFree(goal, model, numbers, *state);
    else
    {
        const auto &tip = std::get<SpatialTipGoal>(task.goal);
        for (const SpatialObstacle &obstacle : model.obstacles)
            if (std::visit(Covers{tip.point, tip.tolerance}, obstacle.shape))
                goal.fault(fmt::format("in collision: every point within the tolerance lies inside {}", obstacle.name));
    }
}
}  // namespace narrows
