// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ompl/base/StateValidityChecker.h>

#include "spaces/ArmStateSpace.h"
#include "validity/ArmChecker.h"
#include "validity/CheckCounts.h"

namespace narrows
{
/// Says whether a state of an `ArmStateSpace` is within its limits and free, by any `ArmChecker`. Counts what it is
/// asked. Safe to share between threads.
class ArmValidityChecker : public ob::StateValidityChecker
{
public:
    /// \pre the state space of `si` is an ArmStateSpace; nothing is null. \param si, checker, counts `counts` grows
    /// with every question
    ArmValidityChecker(const ob::SpaceInformationPtr &si, std::shared_ptr<const ArmChecker> checker,
                       std::shared_ptr<CheckCounts> counts);

    bool isValid(const ob::State *state) const override;  ///< Within the limits and free?

    /// Distance from the arm to the nearest thing it must not touch; negative or zero iff they touch.
    double clearance(const ob::State *state) const override;
    /// The same of a configuration, which need not be a state's: full turns count.
    double clearanceAt(ConfigurationRef q) const;

private:
    const ArmStateSpace *space_;
    std::shared_ptr<const ArmChecker> checker_;
    std::shared_ptr<CheckCounts> counts_;
};
}  // namespace narrows
