// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialTaskCheck.h"

#include <fmt/format.h>

#include "scenario/StateCheck.h"
#include "scenario/YamlMapping.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
/// A place that the goal asks the end of a link to be in.
struct Tip
{
    Field field;
    Eigen::Vector3d point;
};

/// A distance changes no faster than the place, so that what is near enough here is so within the tolerance.
void checkTips(const std::vector<Tip> &tips, const SpatialModel &model, int link, double tolerance)
{
    const double radius = model.arm.links()[static_cast<std::size_t>(link)].radius;
    for (const SpatialObstacle &obstacle : model.obstacles)
    {
        const auto checker = makeAnalyticChecker(SpatialModel{model.arm, {obstacle}});
        for (const Tip &tip : tips)
        {
            const double most = checker->clearance({tip.point, tip.point, 0.0}) + tolerance;
            if (most <= 0.0)
                tip.field.fault(
                    fmt::format("in collision: every point within the tolerance lies inside {}", obstacle.name));
            else if (most <= radius)
                tip.field.fault(fmt::format("in collision: a link of radius {:.6g} that ends there touches {}", radius,
                                            obstacle.name));
        }
    }
}

struct CheckGoal
{
    const Field &field;
    const SpatialModel &model;
    const std::vector<int> &numbers;

    void operator()(const Eigen::VectorXd &state) const { checkStateIsFree(field, model, numbers, state); }
    void operator()(const SpatialTipGoal &tip) const
    {
        checkTips({{field, tip.point}}, model, tip.link, tip.tolerance);
    }
    void operator()(const SpatialTipPath &path) const
    {
        const std::vector<Field> fields = Mapping(field).optional("tip_path").items(1, path.points.size());
        std::vector<Tip> tips;
        for (std::size_t i = 0; i < fields.size(); ++i)
            tips.push_back({fields[i], path.points[i]});
        checkTips(tips, model, path.link, path.tolerance);
    }
};
}  // namespace

void checkTaskIsFree(const Field &start, const Field &goal, const SpatialModel &model, const SpatialTask &task,
                     const std::vector<int> &numbers)
{
    checkStateIsFree(start, model, numbers, task.start);
    std::visit(CheckGoal{goal, model, numbers}, task.goal);
}
}  // namespace narrows
