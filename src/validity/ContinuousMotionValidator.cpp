// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ContinuousMotionValidator.h"

#include "validity/StraightMotion.h"

namespace narrows
{
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
    stopAt(from, to, checker_->freeUntil(q, delta, placements), lastValid);
    counts_->placements.fetch_add(placements, std::memory_order_relaxed);
    return false;
}
}  // namespace narrows
