// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmMotionValidator.h"

namespace narrows
{
ArmMotionValidator::ArmMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const ArmChecker> checker,
                                       std::shared_ptr<CheckCounts> counts)
  : ob::MotionValidator(si),
    space_(si->getStateSpace()->as<ArmStateSpace>()),
    checker_(std::move(checker)),
    counts_(std::move(counts))
{
}

bool ArmMotionValidator::record(bool free) const
{
    // OMPL's own tallies are plain numbers; with several threads they are approximate, ours are not.
    ++(free ? valid_ : invalid_);
    counts_->motionChecks.fetch_add(1, std::memory_order_relaxed);
    return free;
}

void ArmMotionValidator::stopAt(const ob::State *from, const ob::State *to, double part,
                                std::pair<ob::State *, double> &lastValid) const
{
    lastValid.second = part;
    if (lastValid.first != nullptr)
        space_->interpolate(from, to, part, lastValid.first);
}
}  // namespace narrows
