// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/MeasuredPlanner.h"

#include <ompl/base/PlannerData.h>

#include "benchmark/Judging.h"

namespace narrows
{
MeasuredPlanner::MeasuredPlanner(const ob::PlannerPtr &planner, std::shared_ptr<const CheckCounts> counts)
  : ob::Planner(planner->getSpaceInformation(), planner->getName()), planner_(planner), counts_(std::move(counts))
{
    specs_ = planner->getSpecs();
    params_.include(planner->params());
    for (const auto &[name, function] : planner->getPlannerProgressProperties())
        addPlannerProgressProperty(name, function);
}

ob::PlannerStatus MeasuredPlanner::solve(const ob::PlannerTerminationCondition &ptc)
{
    measurement_ = measureSolve(*planner_, ptc, *counts_);
    path_ = copySolution(*pdef_);
    return measurement_.failure ? ob::PlannerStatus(ob::PlannerStatus::CRASH) : measurement_.status;
}

void MeasuredPlanner::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    ob::Planner::setProblemDefinition(pdef);
    planner_->setProblemDefinition(pdef);
}

void MeasuredPlanner::setup()
{
    ob::Planner::setup();
    planner_->setup();
}

void MeasuredPlanner::clear()
{
    ob::Planner::clear();
    planner_->clear();
    path_.reset();
}

void MeasuredPlanner::getPlannerData(ob::PlannerData &data) const
{
    try
    {
        planner_->getPlannerData(data);
    }
    catch (...)
    {
        // OMPL's benchmark would drop the run, or end, for want of two numbers.
        data.clear();
    }
}
}  // namespace narrows
