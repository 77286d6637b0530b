// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include "benchmark/SolveMeasurement.h"

namespace narrows
{
/// Stands before a planner inside OMPL's own benchmark and measures what that cannot: CPU time, checks made by solve()
/// alone, the path before it is simplified. Exceptions become PlannerStatus::CRASH (OMPL's benchmark catches only some
/// of them and loses the whole experiment to the others). Passes on everything else, parameters and progress included.
class MeasuredPlanner : public ob::Planner
{
public:
    MeasuredPlanner(const ob::PlannerPtr &planner, std::shared_ptr<const CheckCounts> counts);

    using ob::Planner::solve;
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    void setProblemDefinition(const ob::ProblemDefinitionPtr &pdef) override;
    void setup() override;
    void clear() override;
    void getPlannerData(ob::PlannerData &data) const override;

    const ob::Planner &planner() const { return *planner_; }
    const SolveMeasurement &measurement() const { return measurement_; }
    /// The solution as the last solve() left it; null without one.
    const og::PathGeometric *path() const { return path_.get(); }

private:
    ob::PlannerPtr planner_;
    std::shared_ptr<const CheckCounts> counts_;
    SolveMeasurement measurement_;
    std::shared_ptr<og::PathGeometric> path_;
};
}  // namespace narrows
