// SPDX-License-Identifier: BSD-3-Clause
#include "planners/HPPM.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <boost/math/constants/constants.hpp>

#include "kernel/FullHomotopy.h"
#include "planners/NumberList.h"
#include "spaces/JointStateSpace.h"

namespace narrows
{
HPPM::HPPM(const ob::SpaceInformationPtr &si, std::shared_ptr<const RepulsionModel> model)
  : ModelPlanner(si, "HPPM"), model_(std::move(model)), space_(jointsOf(si->getStateSpace()))
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    given_.continuous = false;
    given_.strengths = Eigen::MatrixXd::Constant(1, 1, 0.01);
    given_.couplings = Eigen::VectorXd::Ones(1);
    declareParameters();
}

ob::PlannerStatus HPPM::solve(const ob::PlannerTerminationCondition &ptc)
{
    if (space_ == nullptr || static_cast<Eigen::Index>(space_->getDimension()) != joints())
        return refuse("space");
    checkValidity();
    if (!pdef_->getGoal()->hasType(ob::GOAL_SAMPLEABLE_REGION))
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!takeStart())
        return ob::PlannerStatus::INVALID_START;
    space_->toConfiguration(startState_->get(), start_);
    return restarts_ ? restart(ptc) : followGiven(ptc);
}

ob::PlannerStatus HPPM::followGiven(const ob::PlannerTerminationCondition &ptc)
{
    if (!given_.continuous && !model_->supportsPoints())
        return refuse("no_points");
    const CurveRecipe recipe = givenRecipe();
    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when it has none left, nextGoal() does
    // not.
    while (!ptc)
    {
        const ob::State *goal = traces_.empty() ? pis_.nextGoal(ptc) : pis_.nextGoal();
        if (goal == nullptr)
            return traces_.empty() ? ob::PlannerStatus(ob::PlannerStatus::INVALID_GOAL) : giveUp();
        Attempt result = full_ ? attemptFull(recipe, goal, ptc) : attempt(recipe, goal, ptc);
        keep(std::move(result.path), result.reached);
        reason_ = result.reason;
        if (reason_.empty())
            return succeed();
    }
    return solvedBefore() ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

ob::PlannerStatus HPPM::giveUp() const
{
    return solvedBefore() ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::ABORT;
}

ob::PlannerStatus HPPM::succeed()
{
    reason_.clear();
    // A copy, because simplifiers edit solutions in place and getPlannerData() reads traces_.
    pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*traces_.back()), false, 0.0, getName());
    return ob::PlannerStatus::EXACT_SOLUTION;
}

Eigen::VectorXd HPPM::turned(const ob::State *goal, const Eigen::VectorXi &turns) const
{
    ob::ScopedState<> state(si_);
    si_->copyState(state.get(), goal);
    for (Eigen::Index j = 0; j < turns.size(); ++j)
        state->as<ob::RealVectorStateSpace::StateType>()->values[j] += boost::math::double_constants::two_pi * turns[j];
    Eigen::VectorXd q;
    space_->toConfiguration(state.get(), q);
    return q;
}

CurveRecipe HPPM::givenRecipe() const
{
    CurveRecipe recipe = given_;
    const Eigen::Index count = static_cast<Eigen::Index>(model_->groups().size());
    const Eigen::MatrixXd &given = given_.strengths;
    // One number stands for all obstacles; groups that no number is given for (limits, self) have no poles.
    recipe.strengths = Eigen::MatrixXd::Zero(given.rows(), count);
    if (given.cols() == 1)
        recipe.strengths.leftCols(static_cast<Eigen::Index>(model_->obstacleCount())).colwise() = given.col(0);
    else
        recipe.strengths.leftCols(given.cols()) = given;
    if (recipe.couplings.size() == 1)
        recipe.couplings = Eigen::VectorXd::Constant(given.rows(), given_.couplings[0]);
    return recipe;
}

Eigen::MatrixXd HPPM::givenRows() const
{
    if (given_.directions.size() > 0)
        return rowsOfSlice(given_.directions.col(0), given_.couplings[0]);
    return rows_.size() > 0 ? rows_ : Eigen::MatrixXd(Eigen::MatrixXd::Identity(joints(), joints()));
}

std::vector<std::shared_ptr<const Repulsion>> HPPM::repulsions(const CurveRecipe &recipe) const
{
    std::vector<std::shared_ptr<const Repulsion>> result;
    for (Eigen::Index row = 0; row < recipe.strengths.rows(); ++row)
    {
        const Eigen::RowVectorXd strengths = recipe.strengths.row(row);
        const std::vector<double> list(strengths.data(), strengths.data() + strengths.size());
        result.push_back(recipe.continuous ? model_->continuous(list) : model_->points(list, recipe.pointsPerLink));
    }
    return result;
}

TrackerOptions HPPM::trackerOptions(const CurveRecipe &recipe) const
{
    TrackerOptions options;
    options.maxStep =
        maxStep_ > 0.0 ? maxStep_ : unit() * 0.2 * std::sqrt(static_cast<double>(std::max<Eigen::Index>(3, joints())));
    options.firstStep = std::min(unit() * options.firstStep, options.maxStep);
    options.minStep *= unit();
    options.maxSteps = maxSteps_ > 0 ? maxSteps_ : restarts_ ? 200 : 5000;
    options.endShare = restarts_ ? 3e-3 : 0.0;
    options.window = recipe.window;
    return options;
}

SliceHomotopy HPPM::makeSlice(const CurveRecipe &recipe, const Eigen::VectorXd &start,
                              const Eigen::VectorXd &goal) const
{
    const Eigen::VectorXd &from = recipe.fromGoal ? goal : start;
    const Eigen::VectorXd &to = recipe.fromGoal ? start : goal;
    if (recipe.directions.size() == 0)
        return SliceHomotopy::fromRows(repulsions(recipe).front(), from, to, givenRows());
    return {repulsions(recipe), from, to, recipe.directions, recipe.couplings, recipe.schedule};
}

SliceHomotopy HPPM::slice(const ob::State *start, const ob::State *goal) const
{
    const CurveRecipe recipe = givenRecipe();
    return makeSlice(recipe, turned(start, {}), turned(goal, recipe.turns));
}

HPPM::Attempt HPPM::attempt(const CurveRecipe &recipe, const ob::State *goal,
                            const ob::PlannerTerminationCondition &ptc)
{
    last_ = recipe;
    const SliceHomotopy curve = makeSlice(recipe, start_, turned(goal, recipe.turns));
    const auto interrupt = [&ptc]()
    {
        return ptc();
    };
    TrackerOptions options = trackerOptions(recipe);
    const Attempt first = judge(track(curve, options, interrupt), recipe.fromGoal, goal);
    if (!first.reached || first.reason.empty())
        return first;
    options.maxSteps *= 4;
    options.guard = [this](const Eigen::VectorXd &from, const Eigen::VectorXd &to)
    {
        return isFree(from, to);
    };
    const Attempt second = judge(track(curve, options, interrupt), recipe.fromGoal, goal);
    return second.reached ? second : first;
}

HPPM::Attempt HPPM::attemptFull(const CurveRecipe &recipe, const ob::State *goal,
                                const ob::PlannerTerminationCondition &ptc)
{
    spheres_.window = recipe.window;
    const FullHomotopy curve(repulsions(recipe).front(), start_, turned(goal, recipe.turns), givenRows());
    return judge(traceSpheres(curve, spheres_, [&ptc]() { return ptc(); }), false, goal);
}

HPPM::Attempt HPPM::judge(const Trace &trace, bool fromGoal, const ob::State *goal)
{
    measure(trace);
    Attempt result{nullptr, trace.status == TraceStatus::ReachedGoal, toString(trace.status)};
    if (result.reached || !restarts_)  // what restarts try in vain is not kept
        result.path = toPath(trace, fromGoal, goal);
    if (result.reached)
        result.reason = isFree(*result.path) ? "" : "collision";
    return result;
}

std::shared_ptr<og::PathGeometric> HPPM::toPath(const Trace &trace, bool fromGoal, const ob::State *goal) const
{
    auto path = std::make_shared<og::PathGeometric>(si_);
    std::vector<ob::State *> &states = path->getStates();
    for (const Eigen::VectorXd &q : trace.configurations)
    {
        states.push_back(si_->allocState());
        space_->fromConfiguration(q, states.back());
    }
    if (fromGoal)
        std::reverse(states.begin(), states.end());
    // The ends that a trace touches are these states exactly: OMPL's default goal tolerance is machine epsilon.
    const bool reached = trace.status == TraceStatus::ReachedGoal;
    if (reached && states.size() == 1)
        states.push_back(si_->cloneState(goal));
    if (reached || !fromGoal)
        si_->copyState(states.front(), startState_->get());
    if (reached || fromGoal)
        si_->copyState(states.back(), goal);
    return path;
}

bool HPPM::isFree(const og::PathGeometric &path) const
{
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        if (!isFree(path.getState(i - 1), path.getState(i)))
            return false;
    return true;
}

bool HPPM::isFree(const ob::State *from, const ob::State *to) const
{
    // A checker is asked about states within the bounds only: whoever wrote it may have relied on that.
    return si_->satisfiesBounds(from) && si_->satisfiesBounds(to) && si_->checkMotion(from, to);
}

void HPPM::keep(std::shared_ptr<og::PathGeometric> path, bool reached)
{
    traces_.push_back(std::move(path));
    reached_.push_back(reached);
}

void HPPM::measure(const Trace &trace)
{
    measures_["homotopy_evaluations"] += static_cast<double>(trace.evaluations);
    measures_[full_ && !restarts_ ? "hyperspheres" : "steps"] += trace.steps;
    measures_["rejected_steps"] += trace.rejected;
    measures_["wrong_roots"] += trace.wrongRoots;
    measures_["traces"] += 1.0;
    if (restarts_)
        measures_["ended_" + toString(trace.status)] += 1.0;
}

void HPPM::clear()
{
    ModelPlanner::clear();
    targets_.clear();
    attempts_ = 0;
    last_.reset();
    traces_.clear();
    reached_.clear();
}

std::map<std::string, std::string> HPPM::recipe() const
{
    if (!last_)
        return {};
    std::map<std::string, std::string> parameters = last_->parameters();
    if (last_->directions.size() == 0)
    {
        parameters.erase("direction");
        parameters["rows"] = toText(givenRows());
    }
    return parameters;
}

void HPPM::getPlannerData(ob::PlannerData &data) const
{
    Planner::getPlannerData(data);
    for (std::size_t k = 0; k < traces_.size(); ++k)
        addPath(*traces_[k], reached_[k], data);
}
}  // namespace narrows
