// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ContinuousMotionValidator.h"

#include "validity/StraightMotion.h"

namespace narrows
{
ContinuousMotionValidator::ContinuousMotionValidator(const ob::SpaceInformationPtr &si,
                                                     std::shared_ptr<const ArmChecker> checker,
                                                     std::shared_ptr<CheckCounts> counts)
  : ob::MotionValidator(si),
    space_(si->getStateSpace()->as<ArmStateSpace>()),
    checker_(std::move(checker)),
    counts_(std::move(counts))
{
}

bool ContinuousMotionValidator::checkMotion(const ob::State *from, const ob::State *to) const
{
    if (!space_->satisfiesBounds(to))
        return record(false);
    const auto &[q, delta] = straightMotion(*space_, from, to);
    std::uint64_t placements = 0;
    const bool free = checker_->isMotionFree(q, delta, placements);
    counts_->placements.fetch_add(placements, std::memory_order_relaxed);
    return record(free);
}

bool ContinuousMotionValidator::checkMotion(const ob::State *from, const ob::State *to,
                                            std::pair<ob::State *, double> &lastValid) const
{
    if (checkMotion(from, to))
        return true;
    const auto &[q, delta] = straightMotion(*space_, from, to);
    std::uint64_t placements = 0;
    lastValid.second = checker_->freeUntil(q, delta, placements);
    counts_->placements.fetch_add(placements, std::memory_order_relaxed);
    if (lastValid.first != nullptr)
        si_->getStateSpace()->interpolate(from, to, lastValid.second, lastValid.first);
    return false;
}

bool ContinuousMotionValidator::record(bool free) const
{
    // OMPL's own tallies are plain numbers; with several threads they are approximate, ours are not.
    ++(free ? valid_ : invalid_);
    counts_->motionChecks.fetch_add(1, std::memory_order_relaxed);
    return free;
}
}  // namespace narrows
