// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmValidityChecker.h"

namespace narrows
{
namespace
{
/// Forward kinematics of a state, into memory that is kept between calls.
const std::vector<Eigen::Vector2d> &place(const PlanarArmStateSpace &space, const ob::State *state)
{
    struct Workspace
    {
        Eigen::VectorXd q;
        std::vector<Eigen::Vector2d> points;
    };
    thread_local Workspace workspace;
    space.toAbsolute(state, workspace.q);
    space.arm().place(workspace.q, workspace.points);
    return workspace.points;
}
}  // namespace

ArmValidityChecker::ArmValidityChecker(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarChecker> checker,
                                       std::shared_ptr<CheckCounts> counts)
  : ob::StateValidityChecker(si),
    space_(si->getStateSpace()->as<PlanarArmStateSpace>()),
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
    return armClears(*checker_, space_->arm(), place(*space_, state));
}

double ArmValidityChecker::clearance(const ob::State *state) const
{
    counts_->placements.fetch_add(1, std::memory_order_relaxed);
    return armClearance(*checker_, space_->arm(), place(*space_, state));
}
}  // namespace narrows
