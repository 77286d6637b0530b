// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/StateValidityChecker.h>

#include "spaces/PlanarArmStateSpace.h"
#include "validity/CheckCounts.h"
#include "validity/PlanarChecker.h"

namespace narrows
{
/// Says whether a state of a `PlanarArmStateSpace` is within its limits and free, by any `PlanarChecker`. Counts what
/// it is asked. Safe to share between threads.
class ArmValidityChecker : public ob::StateValidityChecker
{
public:
    ArmValidityChecker(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarChecker> checker,
                       std::shared_ptr<CheckCounts> counts);

    bool isValid(const ob::State *state) const override;

    /// Distance from the arm to the nearest obstacle; negative or zero iff they touch.
    double clearance(const ob::State *state) const override;

private:
    const PlanarArmStateSpace *space_;
    std::shared_ptr<const PlanarChecker> checker_;
    std::shared_ptr<CheckCounts> counts_;
};
}  // namespace narrows
