// SPDX-License-Identifier: BSD-3-Clause
// The schedule of Threader and what its members do when it is their turn.
#include <algorithm>
#include <array>
#include <cmath>

#include "planners/Threader.h"

namespace narrows
{
namespace
{
constexpr int firstBudget = 24;  ///< samples of the first round, times a member's share
constexpr double growth = 1.5;   ///< of that, from round to round
constexpr double mostSamples = 1e6;
constexpr double windingJoints = 8.0;  ///< what windingShare is for
constexpr int firstTraces = 4;         ///< round of the first curves
constexpr int tracesPerRound = 4;
constexpr int leastDimension = 3;   ///< of slices
constexpr double longRange = 3.0;   ///< radians: in the open
constexpr double shortRange = 0.5;  ///< in narrow places
// Trees that are near each other in a slice, but do not meet, need no larger one: what separates them is no matter of
// slices. After 120 samples they are as near as 0.05 to 0.18 of the way in the horn, where slices never solve, and 0.6
// in case 3, where they do.
constexpr double nearPart = 0.15;   ///< of the way between start and goal
constexpr double leastGain = 0.99;  ///< less is no coming nearer
constexpr int patience = 3;         ///< a turn by this, in samples, is how long they may come no nearer
// A sample in a slice may slide along gaps for as long as hundreds of others take, and out of the slice: all of joint
// space does that too. A chain of 20 links spent a third of a maze there.
constexpr double mostSlides = 3.0;  ///< centred steps that are tried in a slice's turn, by samples and per joint
constexpr int openSamples = 48;     ///< that are taken for samples in the open, to begin with
}  // namespace

const Threader::Trait &Threader::traitOf(Member::Kind kind)
{
    static const std::array<Trait, 4> traits{
        {{"full", 2, 2, 0, longRange}, {"slice", 5, 1, 0, 0.8}, {"cells", 1, 40, 2, 2.8}, {"traces", 0, 0, 0, 0.0}}};
    return traits[static_cast<std::size_t>(kind)];
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
        members_.push_back({Member::Kind::Full});
    if (traces_ && repulsion_)
        members_.push_back({Member::Kind::Traces});
    if (slices_)
    {
        const int most = std::min(sliceDimensions_, static_cast<int>(chart_.dimension()));
        for (int dimension = std::min(leastDimension, most); dimension <= most; ++dimension)
            members_.push_back({Member::Kind::Slice, dimension});
    }
    if (cells_)
        members_.push_back({Member::Kind::Cells});
}

void Threader::makeSlices()
{
    const int offset = planar_ && planar_->arm.slide() ? 1 : 0;
    const int joints = static_cast<int>(chart_.dimension()) - offset;
    Eigen::MatrixXd modes = cosineModes(joints, std::min(joints, sliceDimensions_), offset);
    for (Eigen::Index k = 0; k < modes.cols(); ++k)
        modes.col(k) = chart_.fromConfiguration(modes.col(k));
    search_->setSlices(affineSlices(search_->root(0, 0), search_->root(1, 0), modes, sliceDimensions_));
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
    if (member.kind == Member::Kind::Slice && search_->slices().dimensions() == 0)
        makeSlices();
    if (member.kind == Member::Kind::Slice && member.dimension > search_->slices().dimensions())
        return false;  // what it would add is in the smaller ones
    if (member.kind == Member::Kind::Slice && !member.samples)
        member.samples.emplace(randomPoint(member.dimension));
    const Trait &trait = traitOf(member.kind);
    // What looks winding may only hide its gap: every other round, the first too, goes on as if it did. But cells come
    // early: slices solve at once what bends evenly, if at all.
    const bool isWinding =
        search_->isWinding() && (round_ % 2 == 1 || (round_ == 0 && member.kind == Member::Kind::Cells));
    const double joints = static_cast<double>(chart_.dimension());
    const double share =
        isWinding ? trait.windingShare * std::pow(joints / windingJoints, trait.windingPower) : trait.share;
    const int budget = static_cast<int>(std::min(share * firstBudget * std::pow(growth, round_), mostSamples));
    const double slidesUntil = static_cast<double>(search_->counts().slides()) + mostSlides * budget / joints;
    for (; used_ < budget && !ptc; ++used_)
    {
        addGoals();
        if (grow(member, ptc))
            return true;
        const bool hasSlidEnough = static_cast<double>(search_->counts().slides()) > slidesUntil;
        if (member.kind == Member::Kind::Slice && (isInVain(budget) || hasSlidEnough))
            break;
    }
    return false;
}

bool Threader::isInVain(int budget)
{
    const double distance = search_->leastDistance();
    const bool comesNearer = distance < leastGain * nearest_;
    nearest_ = comesNearer ? distance : nearest_;
    vainSamples_ = comesNearer ? 0 : vainSamples_ + 1;
    return vainSamples_ > budget / patience && search_->isWinding() &&
           distance < nearPart * (search_->root(1, 0) - search_->root(0, 0)).norm();
}

bool Threader::grow(Member &member, const ob::PlannerTerminationCondition &ptc)
{
    switch (member.kind)
    {
        case Member::Kind::Slice:
            return growSlice(member, ptc);
        case Member::Kind::Cells:
            return search_->explore(traitOf(member.kind).range, rng_, ptc);
        default:
            return growFull(ptc);
    }
}

bool Threader::growFull(const ob::PlannerTerminationCondition &ptc)
{
    // Independent samples: of low discrepancy, the first few dozen were measured to be worse in 8 dimensions.
    const Eigen::VectorXd sample =
        chart_.lower() + randomPoint(chart_.dimension()).cwiseProduct(chart_.upper() - chart_.lower());
    const int number = fullSamples_++;
    const bool isLong = number < openSamples || number / 2 % 2 == 0;
    const double range = range_ > 0.0 ? range_ : (isLong ? longRange : shortRange);
    // Long steps end in several obstacles at once, and hardly ever get out of them.
    return search_->grow({0, range, range < longRange}, sample, rng_, ptc);
}

bool Threader::growSlice(Member &member, const ob::PlannerTerminationCondition &ptc)
{
    const AffineSlices &slices = search_->slices();
    const double joints = static_cast<double>(chart_.dimension());
    const double box = sliceBox_ * std::sqrt(joints / member.dimension);
    Eigen::VectorXd place = box * (2.0 * member.samples->next().array() - 1.0);
    place[0] += 0.5 * (search_->root(1, 0) - search_->root(0, 0)).norm();
    const double range = sliceRange_ > 0.0 ? sliceRange_ : traitOf(member.kind).range;
    return search_->grow({member.dimension, range}, slices.point(place), rng_, ptc);
}

bool Threader::trace(const ob::PlannerTerminationCondition &ptc)
{
    // In a maze a curve costs as much as dozens of samples and seldom arrives: trees come first. Where they thread
    // gaps, one curve may go through several at once; what a sample costs there grows with the joints.
    const bool isThreading = search_->isThreading();
    if (round_ < firstTraces && !isThreading)
        return false;
    if (!curves_)
    {
        curves_ = std::make_shared<HPPM>(si_, repulsion_());
        curves_->setName(getName());
        curves_->setProblemDefinition(pdef_);
    }
    tries_ += isThreading ? std::max(tracesPerRound, static_cast<int>(chart_.dimension())) : tracesPerRound;
    curves_->setTries(tries_);
    return curves_->solve(ptc) == ob::PlannerStatus::EXACT_SOLUTION;
}

void Threader::addGoals()
{
    // As many as RRT-Connect: half the goal's tree. The first ones may lie where no way leads to.
    if (!pis_.haveMoreGoalStates() || 2 * search_->roots(1) > search_->tree(1).size())
        return;
    if (const ob::State *goal = pis_.nextGoal())
        search_->addGoal(goal);
}

void Threader::passOn()
{
    used_ = 0;
    if (++member_ < members_.size())
        return;
    member_ = 0;
    vainSamples_ = 0;
    ++round_;
}
}  // namespace narrows
