// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightManeuvering.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

#include "planners/ChainRobot.h"
#include "spaces/TipGoalRegion.h"

namespace narrows
{
namespace
{
/// Is this the space of the robot that the model describes?
template <typename Space, typename Model>
bool isSpaceOf(const Model &model, const ob::StateSpace &space)
{
    const auto *own = dynamic_cast<const Space *>(&space);
    return own != nullptr && own->arm().dimension() == model.arm.dimension();
}
}  // namespace

TightManeuvering::TightManeuvering(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> planar,
                                   std::shared_ptr<const SpatialModel> spatial)
  : ModelPlanner(si, "TightManeuvering"), planar_(std::move(planar)), spatial_(std::move(spatial))
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParameters();
}

std::string TightManeuvering::whyUnsupported(const PlanarModel *planar, const SpatialModel *spatial)
{
    if (planar == nullptr && spatial == nullptr)
        return "tight maneuvering has to know robot and obstacles";
    return planar != nullptr ? whyNoChain(*planar) : whyNoChain(*spatial);
}

bool TightManeuvering::canWork() const
{
    if (!whyUnsupported(planar_.get(), spatial_.get()).empty())
        return false;
    const ob::StateSpace &space = *si_->getStateSpace();
    return planar_ ? isSpaceOf<PlanarArmStateSpace>(*planar_, space)
                   : isSpaceOf<SpatialArmStateSpace>(*spatial_, space);
}

ob::PlannerStatus TightManeuvering::solve(const ob::PlannerTerminationCondition &ptc)
{
    if (!canWork())
        return refuse("space");
    if (const ob::PlannerStatus opened = open(ptc); opened != ob::PlannerStatus::UNKNOWN)
        return opened;
    if (runs_.empty())
    {
        si_->getStateSpace()->as<ArmStateSpace>()->toConfiguration(startState_->get(), start_);
        if (const ob::PlannerStatus refusal = takeGoals(ptc); refusal != ob::PlannerStatus::UNKNOWN)
            return refusal;
    }
    while (!ptc && current_ < runs_.size())
        if (tryNext(ptc))
        {
            reason_.clear();
            pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), false, 0.0, getName());
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
    if (current_ < runs_.size())
    {
        reason_ = "timeout";
        return ob::PlannerStatus::TIMEOUT;
    }
    return ob::PlannerStatus::ABORT;
}

/// UNKNOWN if there is something to do.
ob::PlannerStatus TightManeuvering::takeGoals(const ob::PlannerTerminationCondition &ptc)
{
    const ob::Goal *goal = pdef_->getGoal().get();
    if (const auto *tip = dynamic_cast<const TipGoalRegion *>(goal))
    {
        if (tip->goal().link != planar_->arm.linkCount() - 1)
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        runs_.push_back(
            makeTightRun(si_, *planar_, settings_, start_, {tip->goal().point, std::nullopt, tip->goal().tolerance}));
        return ob::PlannerStatus::UNKNOWN;
    }
    if (const auto *tip = dynamic_cast<const SpatialTipGoalRegion *>(goal))
    {
        if (tip->goal().link != spatial_->arm.linkCount() - 1)
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        runs_.push_back(
            makeTightRun(si_, *spatial_, settings_, start_, {tip->goal().point, std::nullopt, tip->goal().tolerance}));
        return ob::PlannerStatus::UNKNOWN;
    }
    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when it has none left.
    for (const ob::State *state = pis_.nextGoal(ptc); state != nullptr; state = ptc ? nullptr : pis_.nextGoal())
        addRun(state);
    return runs_.empty() ? ob::PlannerStatus::INVALID_GOAL : ob::PlannerStatus::UNKNOWN;
}

void TightManeuvering::addRun(const ob::State *goal)
{
    Eigen::VectorXd values;
    si_->getStateSpace()->as<ArmStateSpace>()->toConfiguration(goal, values);
    if (planar_)
    {
        const auto *space = si_->getStateSpace()->as<PlanarArmStateSpace>();
        const Eigen::Vector2d tip = space->tip(goal, planar_->arm.linkCount() - 1);
        runs_.push_back(makeTightRun(si_, *planar_, settings_, start_, {tip, values, 0.0}));
        return;
    }
    const auto *space = si_->getStateSpace()->as<SpatialArmStateSpace>();
    const Eigen::Vector3d tip = space->tip(goal, spatial_->arm.linkCount() - 1);
    runs_.push_back(makeTightRun(si_, *spatial_, settings_, start_, {tip, values, 0.0}));
}

bool TightManeuvering::tryNext(const ob::PlannerTerminationCondition &ptc)
{
    TightRun &run = *runs_[current_];
    const std::string refusal = run.refusal();
    if (!refusal.empty())
    {
        reason_ = refusal;
        ++current_;
        return false;
    }
    const TightOutcome outcome = run.next([&ptc] { return ptc(); });
    measures_["tries"] += 1.0;
    collectMeasures();
    reason_ = outcome.failure;
    keep(outcome);
    if (run.isDone() && !outcome.failure.empty())
        ++current_;
    return outcome.failure.empty();
}

void TightManeuvering::keep(const TightOutcome &outcome)
{
    path_ = std::make_shared<og::PathGeometric>(si_);
    ob::ScopedState<> state(si_);
    for (const Eigen::VectorXd &values : outcome.states)
    {
        si_->getStateSpace()->as<ArmStateSpace>()->fromConfiguration(values, state.get());
        path_->append(state.get());
    }
}

void TightManeuvering::collectMeasures()
{
    for (const auto &[name, value] : runs_[current_]->measures())
        measures_[name] = value;
}

void TightManeuvering::clear()
{
    ModelPlanner::clear();
    runs_.clear();
    current_ = 0;
    path_.reset();
}

void TightManeuvering::getPlannerData(ob::PlannerData &data) const
{
    ModelPlanner::getPlannerData(data);
    if (path_)
        addPath(*path_, reason_.empty(), data);
}
}  // namespace narrows
