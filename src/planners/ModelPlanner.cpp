// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ModelPlanner.h"

#include <ompl/base/PlannerData.h>

namespace narrows
{
void ModelPlanner::clear()
{
    Planner::clear();
    startState_.reset();
    reason_.clear();
    measures_.clear();
}

ob::PlannerStatus ModelPlanner::open(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (!pdef_->getGoal()->hasType(ob::GOAL_SAMPLEABLE_REGION))
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!takeStart())
        return ob::PlannerStatus::INVALID_START;
    if (pdef_->hasExactSolution())
        return ob::PlannerStatus::EXACT_SOLUTION;
    reason_ = "timeout";
    return ptc ? ob::PlannerStatus::TIMEOUT : ob::PlannerStatus::UNKNOWN;
}

ob::PlannerStatus ModelPlanner::refuse(const std::string &reason)
{
    checkValidity();
    reason_ = reason;
    return ob::PlannerStatus::ABORT;
}

bool ModelPlanner::takeStart()
{
    if (startState_)
        return true;
    const ob::State *state = pis_.nextStart();
    if (state == nullptr)
        return false;
    startState_.emplace(si_->getStateSpace(), state);
    return true;
}

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
