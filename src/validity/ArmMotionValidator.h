// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>

#include "spaces/ArmStateSpace.h"
#include "validity/ArmChecker.h"
#include "validity/CheckCounts.h"

namespace narrows
{
/// What the motion validators of an arm have in common: whom they ask, and that they count. How a motion is decided is
/// theirs. Safe to share between threads.
class ArmMotionValidator : public ob::MotionValidator
{
public:
    /// \pre the state space of `si` is an ArmStateSpace; nothing is null. \param si, checker, counts `counts` grows
    /// with every question
    ArmMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const ArmChecker> checker,
                       std::shared_ptr<CheckCounts> counts);

protected:
    /// Counts a motion that a planner has asked about. \return `free`
    bool record(bool free) const;

    /// Makes `lastValid` that part of the motion, in [0, 1], and its state if one is wanted.
    void stopAt(const ob::State *from, const ob::State *to, double part,
                std::pair<ob::State *, double> &lastValid) const;

    const ArmStateSpace *space_;                 ///< of the arm
    std::shared_ptr<const ArmChecker> checker_;  ///< decides
    std::shared_ptr<CheckCounts> counts_;        ///< grows
};
}  // namespace narrows
