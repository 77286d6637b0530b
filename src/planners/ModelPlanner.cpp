// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ModelPlanner.h"

#include <ompl/base/PlannerData.h>

namespace narrows
{
void ModelPlanner::addPath(const og::PathGeometric &path, bool reached, ob::PlannerData &data)
{
    const auto state = [&path](std::size_t i)
    {
        return ob::PlannerDataVertex(path.getState(static_cast<unsigned int>(i)));
    };
    data.addStartVertex(state(0));
    for (std::size_t i = 1; i < path.getStateCount(); ++i)
        data.addEdge(state(i - 1), state(i));
    if (reached)
        data.addGoalVertex(state(path.getStateCount() - 1));
}
}  // namespace narrows
