// SPDX-License-Identifier: BSD-3-Clause
#include "planners/HPPM.h"

#include <ompl/base/goals/GoalSampleableRegion.h>

namespace narrows
{
HPPM::HPPM(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> model)
  : ModelPlanner(si, std::move(model), "HPPM"),
    space_(si->getStateSpace()->as<PlanarArmStateSpace>()),
    repulsion_(Eigen::VectorXd::Constant(1, 0.01)),
    startState_(si)
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParameters();
}

ob::PlannerStatus HPPM::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (!pdef_->getGoal()->hasType(ob::GOAL_SAMPLEABLE_REGION))
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!ArmRepulsion::supports(*model_))
    {
        reason_ = "polygon";
        return ob::PlannerStatus::ABORT;
    }
    if (start_.size() == 0)
    {
        const ob::State *state = pis_.nextStart();
        if (state == nullptr)
            return ob::PlannerStatus::INVALID_START;
        si_->copyState(startState_.get(), state);
        space_->toAbsolute(state, start_);
    }

    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when it has none left, nextGoal() does
    // not.
    while (!ptc)
    {
        const ob::State *goal = traces_.empty() ? pis_.nextGoal(ptc) : pis_.nextGoal();
        if (goal == nullptr)
            return traces_.empty() ? ob::PlannerStatus(ob::PlannerStatus::INVALID_GOAL) : giveUp();
        if (attempt(goal, ptc))
        {
            // A copy, because simplifiers edit solutions in place and getPlannerData() reads traces_.
            pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*traces_.back()), false, 0.0, getName());
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
    }
    return solvedBefore() ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

bool HPPM::solvedBefore() const
{
    return pdef_->hasExactSolution();
}

ob::PlannerStatus HPPM::giveUp() const
{
    return solvedBefore() ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::ABORT;
}

bool HPPM::attempt(const ob::State *goal, const ob::PlannerTerminationCondition &ptc)
{
    Eigen::VectorXd goalAngles;
    space_->toAbsolute(goal, goalAngles);
    const auto interrupt = [&ptc]()
    {
        return ptc();
    };
    Trace trace;
    if (form_ == "full")
    {
        spheres_.window = window_;
        trace = traceSpheres(makeHomotopy(goalAngles), spheres_, interrupt);
    }
    else
    {
        plane_.window = window_;
        trace = tracePlane(makeHomotopy(goalAngles), plane_, interrupt);
    }
    measure(trace);
    keep(trace, goal);
    reason_ = toString(trace.status);
    if (trace.status != TraceStatus::ReachedGoal)
        return false;
    reason_ = isFree(*traces_.back()) ? "" : "collision";
    return reason_.empty();
}

ArmHomotopy HPPM::makeHomotopy(const Eigen::VectorXd &goal) const
{
    std::vector<double> strengths(model_->obstacles.size(), repulsion_[0]);
    if (repulsion_.size() > 1)
        strengths.assign(repulsion_.data(), repulsion_.data() + repulsion_.size());
    ArmRepulsion repulsion(*model_, strengths, pointsPerLink_);
    if (direction_.size() > 0)
        return ArmHomotopy::fromDirection(std::move(repulsion), start_, goal, direction_, strength_);
    const Eigen::Index n = start_.size();
    return ArmHomotopy::fromRows(std::move(repulsion), start_, goal,
                                 rows_.size() > 0 ? rows_ : Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n)));
}

void HPPM::keep(const Trace &trace, const ob::State *goal)
{
    auto path = std::make_shared<og::PathGeometric>(si_, startState_.get());
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
    {
        ob::State *state = si_->allocState();
        space_->fromAbsolute(trace.configurations[i], state);
        path->getStates().push_back(state);
    }
    // OMPL's default goal tolerance is machine epsilon: the path ends in the goal state itself.
    if (trace.status == TraceStatus::ReachedGoal && path->getStateCount() > 1)
        si_->copyState(path->getStates().back(), goal);
    reached_.push_back(trace.status == TraceStatus::ReachedGoal);
    traces_.push_back(std::move(path));
}

bool HPPM::isFree(const og::PathGeometric &path) const
{
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        if (!si_->checkMotion(path.getState(i - 1), path.getState(i)))
            return false;
    return true;
}

void HPPM::measure(const Trace &trace)
{
    measures_["homotopy_evaluations"] += static_cast<double>(trace.evaluations);
    measures_[form_ == "full" ? "hyperspheres" : "steps"] += trace.steps;
    measures_["rejected_steps"] += trace.rejected;
    measures_["wrong_roots"] += trace.wrongRoots;
    measures_["traces"] += 1.0;
}

void HPPM::clear()
{
    Planner::clear();
    start_.resize(0);
    traces_.clear();
    reached_.clear();
    reason_.clear();
    measures_.clear();
}

void HPPM::getPlannerData(ob::PlannerData &data) const
{
    Planner::getPlannerData(data);
    for (std::size_t k = 0; k < traces_.size(); ++k)
    {
        const std::vector<ob::State *> &states = traces_[k]->getStates();
        data.addStartVertex(ob::PlannerDataVertex(states.front()));
        for (std::size_t i = 1; i < states.size(); ++i)
            data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
        if (reached_[k])
            data.addGoalVertex(ob::PlannerDataVertex(states.back()));
    }
}
}  // namespace narrows
