// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/MotionValidator.h>

#include "spaces/ArmStateSpace.h"
#include "validity/ArmChecker.h"
#include "validity/CheckCounts.h"

namespace narrows
{
/// Decides motions exactly, without a step size, as `ArmChecker` does. Safe to share between threads.
class ContinuousMotionValidator : public ob::MotionValidator
{
public:
    /// \pre the state space of `si` is an ArmStateSpace; nothing is null. \param si, checker, counts `counts` grows
    /// with every question
    ContinuousMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const ArmChecker> checker,
                              std::shared_ptr<CheckCounts> counts);

    /// \pre `from` is valid, as OMPL has it.
    bool checkMotion(const ob::State *from, const ob::State *to) const override;

    /// If the motion is not free, `lastValid` becomes the end of the stretch from its beginning that is certainly free,
    /// found to 1/256 of the motion.
    bool checkMotion(const ob::State *from, const ob::State *to,
                     std::pair<ob::State *, double> &lastValid) const override;

private:
    bool record(bool free) const;

    const ArmStateSpace *space_;
    std::shared_ptr<const ArmChecker> checker_;
    std::shared_ptr<CheckCounts> counts_;
};
}  // namespace narrows
