// SPDX-License-Identifier: BSD-3-Clause
#include "planners/LegByLeg.h"

#include <map>
#include <stdexcept>
#include <string>

namespace narrows
{
LegByLeg::LegByLeg(const ob::SpaceInformationPtr &si, std::function<ob::PlannerPtr()> make)
  : ModelPlanner(si, "LegByLeg"), make_(std::move(make)), prototype_(make_())
{
    setName(prototype_->getName());
    specs_ = prototype_->getSpecs();
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.approximateSolutions = true;
    specs_.directed = true;
    specs_.canReportIntermediateSolutions = false;
    params_.include(prototype_->params());
}

ob::PlannerStatus LegByLeg::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (dynamic_cast<const TipPathGoal *>(pdef_->getGoal().get()) == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!takeStart())
        return ob::PlannerStatus::INVALID_START;
    if (!path_)
        path_ = std::make_shared<og::PathGeometric>(si_, startState_->get());
    reason_.clear();
    bool stuck = false;
    while (!isDone() && !stuck && !ptc)
        stuck = !advance(ptc);
    measure();
    if (!isDone())
        return giveUp(ptc);
    // A copy, because simplifiers edit solutions in place.
    if (!pdef_->hasExactSolution())
        pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), false, 0.0, getName());
    return ob::PlannerStatus::EXACT_SOLUTION;
}

const TipPathGoal &LegByLeg::goal() const
{
    return *pdef_->getGoal()->as<TipPathGoal>();
}

bool LegByLeg::advance(const ob::PlannerTerminationCondition &ptc)
{
    if (!planning_)
    {
        const auto end = std::make_shared<SpatialTipGoalRegion>(si_, tipGoalAt(goal().path(), reached_));
        if (end->isSatisfied(path_->getStates().back()))
        {
            ++reached_;
            return true;
        }
        beginLeg(end);
    }
    ob::Planner &planner = *legs_.back();
    if (planner.solve(ptc) != ob::PlannerStatus::EXACT_SOLUTION)
        return false;
    append(*planner.getProblemDefinition()->getSolutionPath()->as<og::PathGeometric>());
    planning_ = false;
    ++reached_;
    return true;
}

void LegByLeg::beginLeg(const ob::GoalPtr &end)
{
    const auto problem = std::make_shared<ob::ProblemDefinition>(si_);
    problem->addStartState(path_->getStates().back());
    problem->setGoal(end);
    if (pdef_->hasOptimizationObjective())
        problem->setOptimizationObjective(pdef_->getOptimizationObjective());
    legs_.push_back(makeLegPlanner());
    legs_.back()->setProblemDefinition(problem);
    legs_.back()->setup();
    planning_ = true;
}

ob::PlannerPtr LegByLeg::makeLegPlanner() const
{
    const ob::PlannerPtr planner = make_();
    // Only what has been changed since: some setters have effects even if the value stays.
    std::map<std::string, std::string> wanted;
    std::map<std::string, std::string> present;
    prototype_->params().getParams(wanted);
    planner->params().getParams(present);
    for (const auto &[name, value] : wanted)
        if (present[name] != value)
            planner->params().setParam(name, value);
    return planner;
}

void LegByLeg::append(const og::PathGeometric &leg)
{
    for (std::size_t i = 1; i < leg.getStateCount(); ++i)
        path_->append(leg.getState(static_cast<unsigned int>(i)));
}

void LegByLeg::measure()
{
    measures_.clear();
    for (const ob::PlannerPtr &leg : legs_)
        if (const auto *planner = dynamic_cast<const ModelPlanner *>(leg.get()))
            for (const auto &[name, value] : planner->measures())
                measures_[name] += value;
    measures_["points_reached"] = static_cast<double>(reached_);
}

double LegByLeg::remaining() const
{
    const SpatialTipPath &path = goal().path();
    const auto *space = si_->getStateSpace()->as<SpatialArmStateSpace>();
    Eigen::Vector3d from = space->tip(path_->getStates().back(), path.link);
    double length = 0.0;
    for (std::size_t i = reached_; i < path.points.size(); ++i)
    {
        length += (path.points[i] - from).norm();
        from = path.points[i];
    }
    return length;
}

ob::PlannerStatus LegByLeg::giveUp(bool expired)
{
    if (!expired)
    {
        const auto *planner = dynamic_cast<const ModelPlanner *>(legs_.back().get());
        reason_ = planner != nullptr ? planner->reason() : std::string();
        if (reason_.empty())
            reason_ = "leg_gave_up";
    }
    if (path_->getStateCount() > 1)
    {
        pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), true, remaining(), getName());
        return ob::PlannerStatus::APPROXIMATE_SOLUTION;
    }
    return expired ? ob::PlannerStatus::TIMEOUT : ob::PlannerStatus::ABORT;
}

void LegByLeg::clear()
{
    ModelPlanner::clear();
    path_.reset();
    legs_.clear();
    reached_ = 0;
    planning_ = false;
}

void LegByLeg::getPlannerData(ob::PlannerData &data) const
{
    Planner::getPlannerData(data);
    for (const ob::PlannerPtr &leg : legs_)
        leg->getPlannerData(data);
}
}  // namespace narrows
