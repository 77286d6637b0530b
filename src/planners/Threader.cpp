// SPDX-License-Identifier: BSD-3-Clause
#include "planners/Threader.h"

#include <ompl/base/goals/GoalSampleableRegion.h>

#include "kernel/threading/DeepestOverlap.h"
#include "kernel/threading/LinkGaps.h"
#include "kernel/threading/MidGap.h"
#include "kernel/threading/SpatialMidGap.h"
#include "kernel/threading/SpatialOverlap.h"
#include "planners/ElasticBand.h"
#include "spaces/OmplVersions.h"

namespace narrows
{
Threader::Threader(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> planar,
                   std::shared_ptr<const SpatialModel> spatial,
                   std::function<std::shared_ptr<const RepulsionModel>()> repulsion)
  : ModelPlanner(si, "Threader"),
    planar_(std::move(planar)),
    spatial_(std::move(spatial)),
    repulsion_(std::move(repulsion)),
    space_(std::dynamic_pointer_cast<const ArmStateSpace>(si->getStateSpace())),
    chart_(space_ ? JointChart(*space_) : JointChart())
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParameters();
}

ob::PlannerStatus Threader::solve(const ob::PlannerTerminationCondition &ptc)
{
    if (space_ == nullptr)
        return refuse("space");
    const ob::PlannerStatus opened = open(ptc);
    if (opened != ob::PlannerStatus::UNKNOWN)
        return opened;
    if (!search_)
    {
        if (!begin(ptc))
            return ob::PlannerStatus::INVALID_GOAL;
        if (straight_ && goStraight())
            return succeed("straight", ptc);
    }
    while (!ptc && !members_.empty() && round_ < rounds_)
    {
        const Member &member = members_[member_];
        if (run(members_[member_], ptc))
            return succeed(traitOf(member.kind).name, ptc);
        if (!ptc)
            passOn();
    }
    measure();
    if (ptc)
        return ob::PlannerStatus::TIMEOUT;
    reason_ = members_.empty() ? "no_member" : "rounds";
    return ob::PlannerStatus::ABORT;
}

std::unique_ptr<const GapEquations> Threader::makeGapEquations() const
{
    if (centring_ && planar_)
    {
        const double widest = gapWidth_ * reach();
        auto fixed =
            std::make_unique<MidGap>(planar_->arm, findGaps(planar_->obstacles, planar_->arm.radius(), widest));
        if (planar_->selfCollision)
            return std::make_unique<LinkGaps>(planar_->arm, std::move(fixed), widest);
        return fixed;
    }
    if (centring_ && spatial_)
        return std::make_unique<SpatialMidGap>(*spatial_, gapWidth_ * reach());
    return nullptr;
}

std::unique_ptr<Overlap> Threader::makeOverlap() const
{
    if (bending_ && planar_)
        return std::make_unique<DeepestOverlap>(*planar_);
    if (bending_ && spatial_)
        return std::make_unique<SpatialOverlap>(*spatial_);
    return nullptr;
}

bool Threader::begin(const ob::PlannerTerminationCondition &ptc)
{
    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when there is none left.
    const ob::State *goal = pis_.nextGoal(ptc);
    if (goal == nullptr)
        return false;
    const auto findGaps = [this]
    {
        return makeGapEquations();
    };
    search_ = std::make_unique<ThreadingSearch>(si_, chart_, findGaps, makeOverlap(), steps_);
    search_->addStart(startState_->get());
    while (const ob::State *start = pis_.nextStart())
        search_->addStart(start);
    search_->addGoal(goal);
    makeMembers();
    return true;
}

ob::PlannerStatus Threader::succeed(const std::string &member, const ob::PlannerTerminationCondition &ptc)
{
    if (member != traitOf(Member::Kind::Traces).name)
        pdef_->addSolutionPath(search_->path(), false, 0.0, getName());
    if (polish_ != "none")
        polish(ptc);
    reason_.clear();
    measure();
    measures_["solved_by_" + member] = 1.0;
    return ob::PlannerStatus::EXACT_SOLUTION;
}

void Threader::polish(const ob::PlannerTerminationCondition &ptc)
{
    auto &path = *pdef_->getSolutionPath()->as<og::PathGeometric>();
    og::PathSimplifier simplifier(si_);
    simplifier.reduceVertices(path);
    shortcutRandomly(simplifier, path);
    BandWish wish;
    if (polish_ == "clearance")
        wish.clearance = clearance_ * reach();
    measures_["band_moves"] = tightenBand(si_, chart_, path, wish, ptc).moves;
}

void Threader::measure()
{
    const ThreadingSearch::Counts &counts = search_->counts();
    measures_["nodes"] = search_->tree(0).size() + search_->tree(1).size();
    measures_["samples"] = static_cast<double>(counts.samples);
    measures_["draws"] = static_cast<double>(counts.draws);
    measures_["bent_steps"] = static_cast<double>(counts.bent);
    measures_["looks"] = static_cast<double>(counts.looks);
    measures_["blocked_steps"] = static_cast<double>(counts.blocked);
    measures_["centred_steps"] = static_cast<double>(counts.centred);
    measures_["refused_centred_steps"] = static_cast<double>(counts.refused);
    if (curves_)
        measures_["traces"] = curves_->measures().count("traces") > 0 ? curves_->measures().at("traces") : 0.0;
}

void Threader::clear()
{
    ModelPlanner::clear();
    search_.reset();
    members_.clear();
    member_ = 0;
    round_ = used_ = fullSamples_ = vainSamples_ = tries_ = 0;
    nearest_ = std::numeric_limits<double>::infinity();
    curves_.reset();
}

void Threader::getPlannerData(ob::PlannerData &data) const
{
    Planner::getPlannerData(data);
    if (!search_)
        return;
    for (const int side : {0, 1})
    {
        const ThreadingTree &tree = search_->tree(side);
        std::vector<ob::ScopedState<>> states(static_cast<std::size_t>(tree.size()), ob::ScopedState<>(si_));
        for (int node = 0; node < tree.size(); ++node)
        {
            search_->write(side, node, states[static_cast<std::size_t>(node)].get());
            const ob::PlannerDataVertex vertex(states[static_cast<std::size_t>(node)].get());
            if (tree[node].parent >= 0)
            {
                const ob::PlannerDataVertex parent(states[static_cast<std::size_t>(tree[node].parent)].get());
                side == 0 ? data.addEdge(parent, vertex) : data.addEdge(vertex, parent);
            }
            else
                side == 0 ? data.addStartVertex(vertex) : data.addGoalVertex(vertex);
        }
        data.decoupleFromPlanner();
    }
}
}  // namespace narrows
