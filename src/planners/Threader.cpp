// SPDX-License-Identifier: BSD-3-Clause
#include "planners/Threader.h"

#include <algorithm>
#include <cmath>

#include <ompl/base/goals/GoalSampleableRegion.h>

namespace narrows
{
namespace
{
constexpr int firstBudget = 24;  ///< samples in all of joint space in the first round
constexpr int sliceShare = 5;    ///< of that number, samples per slice
constexpr double growth = 1.5;   ///< of that, from round to round
constexpr double mostSamples = 1e6;
constexpr int firstTraces = 4;  ///< round of the first curves
constexpr int tracesPerRound = 4;
constexpr int leastDimension = 3;   ///< of slices
constexpr double longRange = 3.0;   ///< radians: in the open
constexpr double shortRange = 0.5;  ///< in narrow places
constexpr double defaultSliceRange = 0.8;
constexpr int openSamples = 12;  ///< that are taken for samples in the open, to begin with
}  // namespace

Threader::Threader(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> planar,
                   std::function<std::shared_ptr<const RepulsionModel>()> repulsion)
  : ModelPlanner(si, "Threader"),
    planar_(std::move(planar)),
    repulsion_(std::move(repulsion)),
    space_(si->getStateSpace()->as<ArmStateSpace>()),
    chart_(*space_)
{
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.directed = true;
    declareParameters();
}

ob::PlannerStatus Threader::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (!pdef_->getGoal()->hasType(ob::GOAL_SAMPLEABLE_REGION))
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    if (!search_)
    {
        const ob::PlannerStatus begun = begin(ptc);
        if (begun != ob::PlannerStatus::UNKNOWN)
            return begun;
        if (straight_ && goStraight())
            return succeed("straight");
    }
    while (!ptc && !members_.empty() && round_ < rounds_)
    {
        const Member &member = members_[member_];
        if (run(members_[member_], ptc))
            return succeed(member.kind == Member::Kind::Traces  ? "traces"
                           : member.kind == Member::Kind::Slice ? "slice"
                                                                : "full");
        if (!ptc)
            passOn();
    }
    measure();
    if (solvedBefore())
        return ob::PlannerStatus::EXACT_SOLUTION;
    if (ptc)
        return ob::PlannerStatus::TIMEOUT;
    reason_ = members_.empty() ? "no_member" : "rounds";
    return ob::PlannerStatus::ABORT;
}

void Threader::passOn()
{
    used_ = 0;
    if (++member_ < members_.size())
        return;
    member_ = 0;
    ++round_;
    if (const ob::State *goal = pis_.nextGoal())
        search_->addGoal(goal);
}

ob::PlannerStatus Threader::begin(const ob::PlannerTerminationCondition &ptc)
{
    const ob::State *start = pis_.nextStart();
    if (start == nullptr)
        return ob::PlannerStatus::INVALID_START;
    std::shared_ptr<const MidGap> midGap;
    if (centring_ && planar_)
    {
        const double widest = gapWidth_ * planar_->arm.reach();
        midGap = std::make_shared<MidGap>(planar_->arm, findGaps(planar_->obstacles, planar_->arm.radius(), widest));
    }
    std::unique_ptr<DeepestOverlap> collision;
    if (bending_ && planar_)
        collision = std::make_unique<DeepestOverlap>(*planar_);
    auto search = std::make_unique<ThreadingSearch>(si_, chart_, midGap, std::move(collision));
    for (; start != nullptr; start = pis_.nextStart())
        search->addStart(start);
    // Only the first goal is worth waiting for: nextGoal(ptc) sleeps until ptc when there is none left.
    const ob::State *goal = pis_.nextGoal(ptc);
    if (goal == nullptr)
    {
        pis_.restart();
        return ob::PlannerStatus::INVALID_GOAL;
    }
    search->addGoal(goal);
    search_ = std::move(search);
    makeMembers();
    return ob::PlannerStatus::UNKNOWN;
}

Eigen::VectorXd Threader::randomPoint(Eigen::Index dimension)
{
    Eigen::VectorXd offset(dimension);
    for (double &value : offset)
        value = rng_.uniform01();
    return offset;
}

void Threader::makeMembers()
{
    members_.clear();
    if (full_)
        members_.push_back({Member::Kind::Full, 0, std::nullopt});
    if (slices_)
    {
        const int joints = static_cast<int>(chart_.dimension());
        const int offset = planar_ && planar_->arm.slide() ? 1 : 0;
        Eigen::MatrixXd modes = cosineModes(joints - offset, std::min(joints - offset, sliceDimensions_), offset);
        for (Eigen::Index k = 0; k < modes.cols(); ++k)
            modes.col(k) = chart_.fromConfiguration(modes.col(k));
        search_->setSlices(affineSlices(search_->root(0, 0), search_->root(1, 0), modes, sliceDimensions_));
        const int most = search_->slices().dimensions();
        for (int dimension = std::min(leastDimension, most); dimension <= most; ++dimension)
            members_.push_back({Member::Kind::Slice, dimension, std::nullopt});
    }
    if (traces_ && repulsion_)
        members_.push_back({Member::Kind::Traces, 0, std::nullopt});
}

bool Threader::goStraight()
{
    for (int start = 0; start < search_->roots(0); ++start)
        for (int goal = 0; goal < search_->roots(1); ++goal)
            if (search_->goStraight(start, goal))
                return true;
    return false;
}

bool Threader::run(Member &member, const ob::PlannerTerminationCondition &ptc)
{
    if (member.kind == Member::Kind::Traces)
        return trace(ptc);
    if (member.kind == Member::Kind::Slice && !member.samples)
        member.samples.emplace(randomPoint(member.dimension));
    const int share = member.kind == Member::Kind::Slice ? sliceShare : 1;
    const int budget = static_cast<int>(std::min(share * firstBudget * std::pow(growth, round_), mostSamples));
    for (; used_ < budget && !ptc; ++used_)
        if (member.kind == Member::Kind::Full ? growFull(ptc) : growSlice(member, ptc))
            return true;
    return false;
}

bool Threader::growFull(const ob::PlannerTerminationCondition &ptc)
{
    // Independent samples: of low discrepancy, the first few dozen were measured to be worse in 8 dimensions.
    const Eigen::VectorXd sample =
        chart_.lower() + randomPoint(chart_.dimension()).cwiseProduct(chart_.upper() - chart_.lower());
    const int number = fullSamples_++;
    const bool isLong = number < openSamples || number / 2 % 2 == 0;
    const double range = range_ > 0.0 ? range_ : (isLong ? longRange : shortRange);
    return search_->grow({0, range}, sample, rng_, ptc);
}

bool Threader::growSlice(Member &member, const ob::PlannerTerminationCondition &ptc)
{
    const AffineSlices &slices = search_->slices();
    const double joints = static_cast<double>(chart_.dimension());
    const double box = sliceBox_ * std::sqrt(joints / member.dimension);
    Eigen::VectorXd place = box * (2.0 * member.samples->next().array() - 1.0);
    place[0] += 0.5 * (search_->root(1, 0) - search_->root(0, 0)).norm();
    const double range = sliceRange_ > 0.0 ? sliceRange_ : defaultSliceRange;
    return search_->grow({member.dimension, range}, slices.point(place), rng_, ptc);
}

bool Threader::trace(const ob::PlannerTerminationCondition &ptc)
{
    // In a maze a curve costs as much as dozens of samples and seldom arrives: trees come first.
    if (round_ < firstTraces)
        return false;
    if (!curves_)
    {
        curves_ = std::make_shared<HPPM>(si_, repulsion_());
        curves_->setName(getName());
        curves_->setProblemDefinition(pdef_);
    }
    tries_ += tracesPerRound;
    curves_->setTries(tries_);
    return curves_->solve(ptc) == ob::PlannerStatus::EXACT_SOLUTION;
}

ob::PlannerStatus Threader::succeed(const std::string &member)
{
    if (member != "traces")
        pdef_->addSolutionPath(search_->path(), false, 0.0, getName());
    reason_.clear();
    measure();
    measures_["solved_by_" + member] = 1.0;
    return ob::PlannerStatus::EXACT_SOLUTION;
}

void Threader::measure()
{
    const ThreadingSearch::Counts &counts = search_->counts();
    measures_["nodes"] = search_->tree(0).size() + search_->tree(1).size();
    measures_["samples"] = static_cast<double>(counts.samples);
    measures_["bent_steps"] = static_cast<double>(counts.bent);
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
    round_ = used_ = fullSamples_ = tries_ = 0;
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
