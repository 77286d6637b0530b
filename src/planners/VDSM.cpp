// SPDX-License-Identifier: BSD-3-Clause
#include "planners/VDSM.h"

#include <algorithm>

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planners/NumberList.h"
#include "planners/ObstacleSections.h"
#include "planners/PoseTranslator.h"
#include "spaces/TipPathGoal.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double coarseSteps = 20.0;  ///< per reach
}  // namespace

VDSM::VDSM(const ob::SpaceInformationPtr &si, const std::shared_ptr<const SpatialModel> &model)
  : ModelPlanner(si, "VDSM"),
    model_(model),
    space_(dynamic_cast<const SpatialArmStateSpace *>(si->getStateSpace().get()))
{
    if (whyUnsupported(model.get()).empty())
        chain_ = chainGeometry(model->arm);
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    specs_.approximateSolutions = true;
    declareParameters();
}

std::string VDSM::whyUnsupported(const SpatialModel *model)
{
    if (model == nullptr)
        return "it works in space only";
    const std::optional<ChainGeometry> chain = chainGeometry(model->arm);
    if (!chain)
        return "the scaling method needs a chain of universal joints with one limit, on a slide";
    if (slideAxes(*chain)(0, 0) <= 0.0)
        return "the scaling method needs a slide along the stretched arm, not across it";
    return "";
}

ob::PlannerStatus VDSM::solve(const ob::PlannerTerminationCondition &ptc)
{
    if (!chain_ || space_ == nullptr || space_->arm().dimension() != model_->arm.dimension())
        return refuse("space");
    if (const ob::PlannerStatus opened = open(ptc); opened == ob::PlannerStatus::TIMEOUT)
        return finish(true);
    else if (opened != ob::PlannerStatus::UNKNOWN)
        return opened;
    if (searches_.empty())
    {
        space_->toConfiguration(startState_->get(), start_);
        if (const std::optional<ob::PlannerStatus> refusal = takeGoal(ptc))
            return *refusal;
    }
    while (!ptc && current_ < searches_.size())
        if (tryNext(ptc))
        {
            reason_.clear();
            pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), false, 0.0, getName());
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
    return finish(current_ < searches_.size());
}

/// Makes the searches. A status if there is nothing to search for.
std::optional<ob::PlannerStatus> VDSM::takeGoal(const ob::PlannerTerminationCondition &ptc)
{
    const ob::Goal *goal = pdef_->getGoal().get();
    const auto addTips = [&](const std::vector<Vector3d> &points)
    {
        addSearch(points, std::nullopt);
    };
    if (const auto *path = dynamic_cast<const TipPathGoal *>(goal))
    {
        if (path->path().link != model_->arm.linkCount() - 1)
            return ob::PlannerStatus(ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
        addTips(path->path().points);
        return std::nullopt;
    }
    if (const auto *tip = dynamic_cast<const SpatialTipGoalRegion *>(goal))
    {
        if (tip->goal().link != model_->arm.linkCount() - 1)
            return ob::PlannerStatus(ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
        addTips({tip->goal().point});
        return std::nullopt;
    }
    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when it has none left.
    for (const ob::State *state = pis_.nextGoal(ptc); state != nullptr; state = ptc ? nullptr : pis_.nextGoal())
    {
        Eigen::VectorXd values;
        space_->toConfiguration(state, values);
        addSearch({space_->tip(state, model_->arm.linkCount() - 1)}, values);
    }
    if (searches_.empty())
        return ob::PlannerStatus(ob::PlannerStatus::INVALID_GOAL);
    return std::nullopt;
}

void VDSM::addSearch(const std::vector<Vector3d> &tips, std::optional<Eigen::VectorXd> target)
{
    ScalingProblem problem = scalingProblem(*chain_);
    addObstacles(model_->obstacles, *chain_, problem);
    const PoseTranslator translator(*chain_);
    std::vector<Vector3d> centres;
    translator.toCentres(model_->arm, start_, centres);
    std::vector<Vector3d> waypoints;
    for (const Vector3d &tip : tips)
        waypoints.push_back(translator.toSlideFrame(tip));
    const bool followsPath = waypoints.size() > 1;
    if (!followsPath && settings_.mode == ScalingMode::Taut && settings_.step == 0.0)
    {
        // Where only the last pose matters, a few on the way are tried first: the string needs no others.
        ScalingSettings coarse = settings_;
        coarse.step = problem.reach() / coarseSteps;
        searches_.push_back(
            {std::make_unique<ScalingSearch>(problem, coarse, centres, waypoints), target, followsPath, true});
    }
    searches_.push_back({std::make_unique<ScalingSearch>(problem, settings_, centres, waypoints), std::move(target),
                         followsPath, false});
}

bool VDSM::tryNext(const ob::PlannerTerminationCondition &ptc)
{
    const Search &search = searches_[current_];
    const std::optional<ScaledWay> way = search.ways->next([&ptc] { return ptc(); });
    if (!way)
    {
        if (!ptc)
            ++current_;
        return false;
    }
    Attempt attempt = follow(*way, search, ptc);
    measures_["attempts"] += 1.0;
    measures_["scaled_poses"] += static_cast<double>(way->scaled.poses());
    const bool solved = attempt.reason.empty();
    if (solved || (!search.coarse && (!best_ || attempt.rest < best_->rest)))
    {
        best_ = std::move(attempt);
        path_ = toPath(*best_);
        recipe_ = {{"margin", toText(Eigen::MatrixXd::Constant(1, 1, way->margin))}, {"margins", "1"}};
        measures_["margin"] = way->margin;
        measures_["longer_sides"] = static_cast<double>(std::count(way->longer.begin(), way->longer.end(), true));
    }
    return solved;
}

std::shared_ptr<og::PathGeometric> VDSM::toPath(const Attempt &attempt) const
{
    auto path = std::make_shared<og::PathGeometric>(si_);
    ob::ScopedState<> state(si_);
    for (const Eigen::VectorXd &values : attempt.states)
    {
        space_->fromConfiguration(values, state.get());
        path->append(state.get());
    }
    return path;
}

/// The status when no solution has been found: the longest part is an approximate one.
ob::PlannerStatus VDSM::finish(bool timeout)
{
    reason_ = timeout ? "timeout" : best_ ? best_->reason : "";
    const bool some = best_ && best_->states.size() > 1;
    if (!some)
        return timeout ? ob::PlannerStatus::TIMEOUT : ob::PlannerStatus::ABORT;
    pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), true, best_->rest, getName());
    return ob::PlannerStatus::APPROXIMATE_SOLUTION;
}

void VDSM::clear()
{
    ModelPlanner::clear();
    searches_.clear();
    current_ = 0;
    best_.reset();
    path_.reset();
    recipe_.clear();
}

std::map<std::string, std::string> VDSM::recipe() const
{
    return recipe_;
}

void VDSM::getPlannerData(ob::PlannerData &data) const
{
    ModelPlanner::getPlannerData(data);
    if (path_)
        addPath(*path_, best_->reason.empty(), data);
}
}  // namespace narrows
