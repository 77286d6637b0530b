// SPDX-License-Identifier: BSD-3-Clause
// The restarts of HPPM: which goals, which curves, in which order.
#include <algorithm>
#include <cmath>

#include <boost/math/constants/constants.hpp>

#include "planners/HPPM.h"

namespace narrows
{
ob::PlannerStatus HPPM::restart(const ob::PlannerTerminationCondition &ptc)
{
    const bool fresh = targets_.empty();
    if (fresh && !takeTargets(ptc))
        return ob::PlannerStatus::INVALID_GOAL;
    if (fresh)
        for (const Target &target : targets_)
            if (goStraight(target))
                return succeed();
    while (!ptc)
    {
        if (attempts_ >= tries_)
        {
            reason_ = "tries";
            return giveUp();
        }
        if (tryCurve(nextTarget(), ptc))
            return succeed();
    }
    return solvedBefore() ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::TIMEOUT;
}

bool HPPM::takeTargets(const ob::PlannerTerminationCondition &ptc)
{
    const ob::State *goal = pis_.nextGoal(ptc);
    for (int i = 0; goal != nullptr && i < goalCandidates_; ++i)
    {
        targets_.push_back(makeTarget(goal));
        goal = ptc ? nullptr : pis_.nextGoal();
    }
    std::stable_sort(targets_.begin(), targets_.end(),
                     [](const Target &a, const Target &b) { return a.distance < b.distance; });
    return !targets_.empty();
}

HPPM::Target HPPM::makeTarget(const ob::State *goal) const
{
    Target target{ob::ScopedState<>(si_), si_->distance(startState_->get(), goal), {}, std::nullopt};
    si_->copyState(target.state.get(), goal);
    target.ends.start = start_;
    target.ends.turns = Eigen::VectorXi::Zero(joints());
    const double *from = startState_->get()->as<ob::RealVectorStateSpace::StateType>()->values;
    const double *to = goal->as<ob::RealVectorStateSpace::StateType>()->values;
    for (int j = 0; j < static_cast<int>(joints()); ++j)
        if (space_->wraps(static_cast<unsigned int>(j)))
        {
            target.ends.turns[j] =
                static_cast<int>(std::round((from[j] - to[j]) / boost::math::double_constants::two_pi));
            target.ends.turnable.push_back(j);
        }
    target.ends.goal = turned(goal, target.ends.turns);
    return target;
}

bool HPPM::goStraight(const Target &target)
{
    if (!si_->checkMotion(startState_->get(), target.state.get()))
        return false;
    auto path = std::make_shared<og::PathGeometric>(si_, startState_->get());
    path->append(target.state.get());
    keep(std::move(path), true);
    return true;
}

double HPPM::unit() const
{
    if (space_ == si_->getStateSpace())
        return 1.0;
    const ob::RealVectorBounds &bounds = si_->getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
    double longest = 0.0;
    for (const double side : bounds.getDifference())
        longest = std::max(longest, side);
    // As far as a joint that wraps can be from where it is: pi.
    return longest > 0.0 ? longest / boost::math::double_constants::pi : 1.0;
}

HPPM::Target &HPPM::nextTarget()
{
    // The nearest goal gets every second curve, the next one every fourth, ...
    std::size_t index = 0;
    for (int rest = ++attempts_; rest % 2 == 0 && index + 1 < targets_.size(); rest /= 2)
        ++index;
    return targets_[index];
}

bool HPPM::tryCurve(Target &target, const ob::PlannerTerminationCondition &ptc)
{
    if (!target.sampler)
        target.sampler.emplace(model_, target.ends, poleRows_, unit());
    const CurveRecipe recipe = target.sampler->next(random_);
    Attempt result = attempt(recipe, target.state.get(), ptc);
    if (!result.reason.empty())
        return false;
    keep(std::move(result.path), true);
    return true;
}

bool HPPM::isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
{
    ob::ScopedState<> a(si_), b(si_);
    space_->fromConfiguration(from, a.get());
    space_->fromConfiguration(to, b.get());
    return isFree(a.get(), b.get());
}
}  // namespace narrows
