// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ViaPointHomotopy.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "kernel/trajectory/StopAndGo.h"
#include "spaces/JointStateSpace.h"
#include "spaces/OmplVersions.h"
#include "validity/ArmValidityChecker.h"
#include "validity/TrajectoryCertificate.h"

namespace narrows
{
namespace
{
constexpr double viaSpread = 0.5;            // deviation of a via, in distances from start to goal
constexpr std::uint64_t proofEffort = 3000;  // placements: a motion that needs more grazes something
constexpr int deepestSample = 30;            // halvings of a piece
}  // namespace

ViaPointHomotopy::ViaPointHomotopy(const ob::SpaceInformationPtr &si, bool selfCollision)
  : ModelPlanner(si, "ViaPointHomotopy"),
    space_(jointsOf(si->getStateSpace())),
    selfCollision_(selfCollision),
    velocity_(Eigen::VectorXd::Constant(1, 1.5)),
    acceleration_(Eigen::VectorXd::Constant(1, 4.0)),
    jerk_(Eigen::VectorXd::Constant(1, 20.0))
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    if (space_ != nullptr)
        coordinates_.emplace(*space_);
    declareParameters();
}

ob::PlannerStatus ViaPointHomotopy::solve(const ob::PlannerTerminationCondition &ptc)
{
    if (space_ == nullptr)
        return refuse("space");
    if (const ob::PlannerStatus opened = open(ptc); opened != ob::PlannerStatus::UNKNOWN)
        return opened;
    if (!goal_)
    {
        // Only the first goal is worth waiting for; the trees ask for more.
        const ob::State *goal = pis_.nextGoal(ptc);
        if (goal == nullptr)
            return ob::PlannerStatus::INVALID_GOAL;
        goal_.emplace(si_->getStateSpace(), goal);
    }
    std::optional<og::PathGeometric> found = polyline(ptc);
    measures_["stage"] = static_cast<double>(stage_);
    if (!found)
    {
        if (stage_ != Stage::GaveUp)
            return ob::PlannerStatus::TIMEOUT;
        reason_ = "no_chain";
        return ob::PlannerStatus::ABORT;
    }
    reason_.clear();
    shorten(*found);
    addTrajectory(*found, ptc);
    path_ = sampled(std::move(*found));
    // A copy, because simplifiers edit solutions in place.
    pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), false, 0.0, getName());
    return ob::PlannerStatus::EXACT_SOLUTION;
}

std::optional<og::PathGeometric> ViaPointHomotopy::polyline(const ob::PlannerTerminationCondition &ptc)
{
    if (stage_ == Stage::Straight)
    {
        if (si_->checkMotion(startState_->get(), goal_->get()))
            return og::PathGeometric(si_, startState_->get(), goal_->get());
        stage_ = Stage::OneVia;
    }
    while (stage_ == Stage::OneVia && attempts_ < viaAttempts_ && !ptc)
    {
        measures_["via_attempts"] = ++attempts_;
        if (std::optional<og::PathGeometric> path = throughOneVia())
            return path;
    }
    if (ptc || stage_ == Stage::GaveUp)
        return std::nullopt;
    stage_ = Stage::Chain;
    return throughChain(ptc);
}

std::optional<og::PathGeometric> ViaPointHomotopy::throughOneVia()
{
    const unsigned int joints = si_->getStateDimension();
    const double spread = viaSpread * si_->distance(startState_->get(), goal_->get()) / std::sqrt(joints);
    ob::ScopedState<> via(si_->getStateSpace());
    si_->getStateSpace()->interpolate(startState_->get(), goal_->get(), 0.5, via.get());
    for (unsigned int i = 0; i < joints; ++i)
        via[i] += rng_.gaussian(0.0, spread);
    via.enforceBounds();
    if (!si_->isValid(via.get()) || !si_->checkMotion(startState_->get(), via.get()) ||
        !si_->checkMotion(via.get(), goal_->get()))
        return std::nullopt;
    og::PathGeometric path(si_, startState_->get(), via.get());
    path.append(goal_->get());
    return path;
}

std::optional<og::PathGeometric> ViaPointHomotopy::throughChain(const ob::PlannerTerminationCondition &ptc)
{
    if (!chain_)
    {
        const auto trees = std::make_shared<og::RRTConnect>(si_);
        trees->setRange(range_);
        const auto problem = std::make_shared<ob::ProblemDefinition>(si_);
        problem->addStartState(*startState_);
        problem->setGoal(pdef_->getGoal());
        trees->setProblemDefinition(problem);
        trees->setup();
        chain_ = trees;
    }
    const ob::PlannerStatus status = chain_->solve(ptc);
    if (status == ob::PlannerStatus::EXACT_SOLUTION)
        return *chain_->getProblemDefinition()->getSolutionPath()->as<og::PathGeometric>();
    if (!ptc)
        stage_ = Stage::GaveUp;
    return std::nullopt;
}

void ViaPointHomotopy::shorten(og::PathGeometric &path) const
{
    if (path.getStateCount() < 3)
        return;
    og::PathSimplifier simplifier(si_);
    simplifier.reduceVertices(path);
    shortcutRandomly(simplifier, path);
    simplifier.reduceVertices(path);
    simplifier.collapseCloseVertices(path);
}

void ViaPointHomotopy::addTrajectory(const og::PathGeometric &polyline, const ob::PlannerTerminationCondition &ptc)
{
    vias_ = coordinates_->along(polyline);
    measures_["vias"] = static_cast<double>(vias_.cols()) - 2.0;
    const auto *checker = dynamic_cast<const ArmValidityChecker *>(si_->getStateValidityChecker().get());
    if (!smooth_ || checker == nullptr)
    {
        trajectory_ = sevenPhaseStops(vias_, limits()).value;
        if (trajectory_)
            measures_["duration"] = measures_["stop_duration"] = trajectory_->duration();
        return;
    }
    const TrajectoryCertificate certificate(*space_, [checker](ConfigurationRef q) { return checker->clearanceAt(q); },
                                            selfCollision_, {margin_, proofEffort});
    const auto proof = [&certificate](const JointTrajectory &motion)
    {
        return certificate.check(motion).status == CertificateStatus::Free;
    };
    SmoothingOptions options;
    options.evaluations = evaluations_;
    options.interrupted = [&ptc]
    {
        return ptc();
    };
    const OrFailure<SmoothedTrajectory> smoothed = smoothTrajectory(vias_, limits(), proof, options);
    if (!smoothed)
        return;
    trajectory_ = smoothed->motion;
    measures_["duration"] = trajectory_->duration();
    measures_["stop_duration"] = smoothed->stopDuration;
    measures_["blended"] = smoothed->blended ? 1.0 : 0.0;
    measures_["evaluations"] = smoothed->evaluations;
    measures_["proofs"] = smoothed->proofs;
}

og::PathGeometric ViaPointHomotopy::sampled(og::PathGeometric polyline) const
{
    const auto blended = measures_.find("blended");
    if (blended == measures_.end() || blended->second == 0.0)
        return polyline;
    og::PathGeometric path(si_, polyline.getState(0));
    const std::vector<double> &knots = trajectory_->knots();
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (!sample(knots[i - 1], knots[i], 0, path))
            return polyline;
    si_->copyState(path.getStates().back(), polyline.getStates().back());
    return path;
}

bool ViaPointHomotopy::sample(double from, double to, int depth, og::PathGeometric &path) const
{
    JointTrajectory::States joints;
    trajectory_->at(to, joints);
    ob::ScopedState<> end(si_->getStateSpace());
    coordinates_->toState(joints.col(0), end.get());
    end.enforceBounds();
    if (si_->equalStates(path.getStates().back(), end.get()))
        return true;
    if (si_->checkMotion(path.getStates().back(), end.get()))
    {
        path.append(end.get());
        return true;
    }
    const double middle = 0.5 * (from + to);
    return depth < deepestSample && sample(from, middle, depth + 1, path) && sample(middle, to, depth + 1, path);
}

void ViaPointHomotopy::clear()
{
    ModelPlanner::clear();
    stage_ = Stage::Straight;
    goal_.reset();
    attempts_ = 0;
    chain_.reset();
    path_.reset();
    vias_.resize(0, 0);
    trajectory_.reset();
}

void ViaPointHomotopy::getPlannerData(ob::PlannerData &data) const
{
    ModelPlanner::getPlannerData(data);
    if (chain_)
        chain_->getPlannerData(data);
    if (path_)
        addPath(*path_, true, data);
}
}  // namespace narrows
