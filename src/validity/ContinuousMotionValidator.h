// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/MotionValidator.h>

#include "spaces/PlanarArmStateSpace.h"
#include "validity/CheckCounts.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
/// Decides motions exactly, without a step size: a stretch of a motion is free when, at its middle, every link is
/// further from all obstacles than any of its points can travel to either end, by their speed there and a bound on
/// their acceleration; otherwise the stretch is halved, widest first.
///
/// Motions that come closer than 1e-9 of the arm's reach to an obstacle are refused: they cannot be told from touching.
/// Safe to share between threads.
class ContinuousMotionValidator : public ob::MotionValidator
{
public:
    ContinuousMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarChecker> checker,
                              std::shared_ptr<CheckCounts> counts);

    /// \pre `from` is valid, as OMPL has it.
    bool checkMotion(const ob::State *from, const ob::State *to) const override;

    /// If the motion is not free, `lastValid` becomes the end of the stretch from its beginning that is certainly free,
    /// found to 1/256 of the motion.
    bool checkMotion(const ob::State *from, const ob::State *to,
                     std::pair<ob::State *, double> &lastValid) const override;

private:
    class Motion;

    bool record(bool free) const;

    const PlanarArmStateSpace *space_;
    std::shared_ptr<const PlanarChecker> checker_;
    std::shared_ptr<CheckCounts> counts_;
    double resolution_;  ///< no link is told free by less than this
};
}  // namespace narrows
