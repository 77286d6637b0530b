// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "planners/ModelPlanner.h"
#include "spaces/TipPathGoal.h"

namespace narrows
{
/**
   @anchor LegByLeg
   @par Short description
   Leads a planner that knows one goal at a time along a tip path (TipPathGoal): one planner, made anew, for each leg,
   from where the leg before ended to a SpatialTipGoalRegion, whose samples of inverse kinematics are the same for all
   planners. A point whose tolerance the tip is within already needs no leg. All legs share the time that solve() is
   given.

   What has been reached when that is over, or when a leg's planner gives up, is an approximate solution; its difference
   is the length of tip path that is left. The planner's parameters are those of the planner that it leads.
*/
class LegByLeg : public ModelPlanner
{
public:
    /// \param si of a SpatialArmStateSpace
    /// \param make makes the planner of one leg, every time a new one
    LegByLeg(const ob::SpaceInformationPtr &si, std::function<ob::PlannerPtr()> make);

    /// Besides OMPL's usual statuses: ABORT when the first leg's planner gives up; reason() is then, and for an
    /// approximate solution that is not for want of time, the reason of the leg's planner, or `leg_gave_up` if that
    /// names none. A later call goes on with the leg where this one stopped.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;  ///< Forgets all legs; parameters that were set go to the legs to come.
    /// The data of all legs' planners: a leg's goals are the next one's start.
    void getPlannerData(ob::PlannerData &data) const override;

private:
    const TipPathGoal &goal() const;
    bool isDone() const { return reached_ == goal().path().points.size(); }
    void beginLeg(const ob::GoalPtr &end);
    /// Plans on towards the next point. False if it was not reached.
    bool advance(const ob::PlannerTerminationCondition &ptc);
    void append(const og::PathGeometric &leg);
    ob::PlannerPtr makeLegPlanner() const;
    void measure();
    /// Length of tip path from where the legs have led to its end.
    double remaining() const;
    ob::PlannerStatus giveUp(bool expired);

    std::function<ob::PlannerPtr()> make_;
    ob::PlannerPtr prototype_;  ///< never plans; its parameters are ours, and those of every leg's planner
    std::shared_ptr<og::PathGeometric> path_;  ///< all legs that are done; null before the start is known
    std::size_t reached_ = 0;                  ///< points of the tip path
    std::vector<ob::PlannerPtr> legs_;         ///< planners, the last for the leg that is being planned
    bool planning_ = false;                    ///< is it?
};
}  // namespace narrows
