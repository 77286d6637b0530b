// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TipFollower.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <ompl/base/ScopedState.h>

#include "spaces/TipPathGoal.h"

namespace narrows
{
namespace
{
double lengthOf(const SpatialArm &arm)
{
    double length = 0.0;
    for (const SpatialLink &link : arm.links())
        length += (link.to - link.from).norm();
    return length;
}
}  // namespace

TipFollower::TipFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model,
                         const std::string &name)
  : ModelPlanner(si, name),
    model_(std::move(model)),
    space_(si->getStateSpace()->as<SpatialArmStateSpace>()),
    length_(lengthOf(model_->arm)),
    step_(length_ / 625.0)
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.approximateSolutions = true;
    specs_.directed = true;
    declareParam<double>("step", this, &TipFollower::setStep, &TipFollower::getStep);
    declareParam<double>("precision", this, &TipFollower::setPrecision, &TipFollower::getPrecision, "0:0.01:1");
    declareParam<int>("max_iterations", this, &TipFollower::setMaxIterations, &TipFollower::getMaxIterations,
                      "1:1:1000");
}

void TipFollower::setStep(double step)
{
    if (!(step >= 1e-6 * length_))
        throw std::invalid_argument("step must be at least a millionth of all links' lengths");
    step_ = step;
}

void TipFollower::setPrecision(double share)
{
    if (!(share > 0.0 && share <= 1.0))
        throw std::invalid_argument("precision must be in (0, 1]");
    precision_ = share;
}

void TipFollower::setMaxIterations(int iterations)
{
    // The termination condition is only asked between waypoints.
    if (iterations < 1 || iterations > 1000)
        throw std::invalid_argument("max_iterations must be in [1, 1000]");
    maxIterations_ = iterations;
}

ob::PlannerStatus TipFollower::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    const std::optional<SpatialTipPath> tips = tipPathOf(*pdef_->getGoal());
    if (!tips)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!search_ && !begin(*tips))
        return ob::PlannerStatus::INVALID_START;
    while (!isDone() && reason_.empty() && !ptc)
        advance();
    return conclude(ptc);
}

bool TipFollower::begin(const SpatialTipPath &path)
{
    const ob::State *start = pis_.nextStart();
    if (start == nullptr)
        return false;
    path_ = std::make_shared<og::PathGeometric>(si_, start);
    space_->toConfiguration(start, q_);
    layWaypoints(path, space_->tip(start, path.link));
    search_ = makeSearch(taskFor(path));
    return true;
}

void TipFollower::layWaypoints(const SpatialTipPath &path, const Eigen::Vector3d &from)
{
    Eigen::Vector3d last = from;
    for (std::size_t i = 0; i < path.points.size(); ++i)
    {
        const Eigen::Vector3d way = path.points[i] - last;
        const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / step_)));
        for (int k = 1; k < steps; ++k)
            waypoints_.push_back({last + way * k / steps, static_cast<int>(i)});
        last = path.points[i];
        waypoints_.push_back({last, static_cast<int>(i + 1)});
    }
}

TipSearchTask TipFollower::taskFor(const SpatialTipPath &path) const
{
    const auto enforce = [space = space_, state = std::make_shared<ob::ScopedState<>>(si_)](Eigen::VectorXd &q)
    {
        space->fromConfiguration(q, state->get());
        if (space->satisfiesBounds(state->get()))
            return false;
        space->enforceBounds(state->get());
        space->toConfiguration(state->get(), q);
        return true;
    };
    return {path.link, precision_ * path.tolerance, maxIterations_, enforce};
}

void TipFollower::advance()
{
    Eigen::VectorXd q = q_;
    const TipSearchResult result = search_->reach(waypoints_[next_].place, q);
    measures_["iterations"] += result.iterations;
    measures_["most_iterations"] = std::max<double>(measures_["most_iterations"], result.iterations);
    if (result.status != TipSearchStatus::Reached)
    {
        reason_ = result.status == TipSearchStatus::AtLimit ? "limit" : "no_convergence";
        return;
    }
    ob::ScopedState<> state(si_);
    space_->fromConfiguration(q, state.get());
    if (!si_->checkMotion(path_->getStates().back(), state.get()))
    {
        reason_ = "collision";
        return;
    }
    path_->append(state.get());
    q_ = q;
    ++next_;
    measures_["waypoints"] = static_cast<double>(next_);
    measures_["points_reached"] = waypoints_[next_ - 1].points;
}

double TipFollower::remaining() const
{
    double length = 0.0;
    Eigen::Vector3d last = waypoints_[next_ - 1].place;
    for (std::size_t i = next_; i < waypoints_.size(); ++i)
    {
        length += (waypoints_[i].place - last).norm();
        last = waypoints_[i].place;
    }
    return length;
}

ob::PlannerStatus TipFollower::conclude(bool expired)
{
    const auto add = [this](bool approximate, double difference)
    {
        // A copy, because simplifiers edit solutions in place and getPlannerData() points into path_.
        pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), approximate, difference, getName());
    };
    if (isDone())
    {
        if (!pdef_->hasExactSolution())
            add(false, 0.0);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }
    if (next_ > 0)
    {
        add(true, remaining());
        return ob::PlannerStatus::APPROXIMATE_SOLUTION;
    }
    return expired && reason_.empty() ? ob::PlannerStatus::TIMEOUT : ob::PlannerStatus::ABORT;
}

void TipFollower::clear()
{
    ModelPlanner::clear();
    search_.reset();
    waypoints_.clear();
    next_ = 0;
    path_.reset();
}

void TipFollower::getPlannerData(ob::PlannerData &data) const
{
    Planner::getPlannerData(data);
    if (path_)
        addPath(*path_, isDone(), data);
}
}  // namespace narrows
