// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/TaskCheck.h"

#include <numeric>

#include <fmt/format.h>

#include "scenario/StateCheck.h"
#include "validity/DiscCover.h"

namespace narrows
{
namespace
{
void checkTipGoal(const Field &field, const PlanarModel &model, const TipGoal &goal)
{
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (coversDisc(obstacle, goal.point, goal.tolerance))
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
