// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validity/ArmMotionValidator.h"

namespace narrows
{
/// Answers as OMPL's DiscreteMotionValidator does: a motion is free if its states are that divide it into
/// validSegmentCount() equal parts. Asks about many of them at once, which is several times faster (see
/// `ArmChecker::areFree`). Limits of joints are asked at the end only, as they are convex. Safe to share between
/// threads.
class SampledMotionValidator : public ArmMotionValidator
{
public:
    using ArmMotionValidator::ArmMotionValidator;

    /// \pre `from` is valid, as OMPL has it.
    bool checkMotion(const ob::State *from, const ob::State *to) const override;

    /// If the motion is not free, `lastValid` becomes the last state before the first that is not.
    bool checkMotion(const ob::State *from, const ob::State *to,
                     std::pair<ob::State *, double> &lastValid) const override;

private:
    class Samples;
};
}  // namespace narrows
