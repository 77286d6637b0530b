// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmValidityChecker.h"

namespace narrows
{
namespace
{
/// The state as the kernel counts it, in memory that is kept between calls.
const Eigen::VectorXd &configuration(const ArmStateSpace &space, const ob::State *state)
{
    thread_local Eigen::VectorXd q;
    space.toConfiguration(state, q);
    return q;
}
}  // namespace

ArmValidityChecker::ArmValidityChecker(const ob::SpaceInformationPtr &si, std::shared_ptr<const ArmChecker> checker,
                                       std::shared_ptr<CheckCounts> counts)
  : ob::StateValidityChecker(si),
    space_(si->getStateSpace()->as<ArmStateSpace>()),
    checker_(std::move(checker)),
    counts_(std::move(counts))
{
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool ArmValidityChecker::isValid(const ob::State *state) const
{
    counts_->stateChecks.fetch_add(1, std::memory_order_relaxed);
    if (!space_->satisfiesBounds(state))
        return false;
    counts_->placements.fetch_add(1, std::memory_order_relaxed);
    return checker_->isFree(configuration(*space_, state));
}

double ArmValidityChecker::clearance(const ob::State *state) const
{
    return clearanceAt(configuration(*space_, state));
}

double ArmValidityChecker::clearanceAt(ConfigurationRef q) const
{
    counts_->placements.fetch_add(1, std::memory_order_relaxed);
    return checker_->clearance(q);
}
}  // namespace narrows
