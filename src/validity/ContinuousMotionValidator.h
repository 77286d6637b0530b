// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validity/ArmMotionValidator.h"

namespace narrows
{
/// Decides motions exactly, without a step size, as `ArmChecker` does. Safe to share between threads.
class ContinuousMotionValidator : public ArmMotionValidator
{
public:
    using ArmMotionValidator::ArmMotionValidator;

    /// \pre `from` is valid, as OMPL has it.
    bool checkMotion(const ob::State *from, const ob::State *to) const override;

    /// If the motion is not free, `lastValid` becomes the end of the stretch from its beginning that is certainly free,
    /// found to 1/256 of the motion.
    bool checkMotion(const ob::State *from, const ob::State *to,
                     std::pair<ob::State *, double> &lastValid) const override;
};
}  // namespace narrows
