// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/DampedTipSearch.h"

#include <algorithm>

#include "kernel/DampedStep.h"
#include "kernel/TipJacobian.h"

namespace narrows
{
namespace
{
constexpr double longestStep = 0.5;  // in units of the search; near singular postures joints would wind up
}

DampedTipSearch::DampedTipSearch(const SpatialArm &arm, TipSearchTask task, DampedTipSearchOptions options)
  : arm_(arm),
    task_(std::move(task)),
    options_(std::move(options)),
    units_(jointUnits(arm)),
    damping_(options_.lambda * options_.lambda * arm.reach() * arm.reach())
{
}

TipSearchResult DampedTipSearch::reach(const Eigen::Vector3d &target, Eigen::VectorXd &q)
{
    const int nullSteps = options_.nullMotion ? options_.nullSteps : 0;
    bool limited = false;
    for (int i = 0; i < task_.maxIterations; ++i)
    {
        arm_.place(q, placement_);
        const Eigen::Vector3d error = target - placement_.points[2 * task_.link + 1];
        if (i >= nullSteps && error.norm() <= task_.precision)
            return {TipSearchStatus::Reached, i + 1};
        const Eigen::VectorXd move = step(error, q, i < nullSteps);
        q += std::min(1.0, longestStep / move.norm()) * move.cwiseProduct(units_);
        limited = task_.enforceLimits(q);
    }
    return {limited ? TipSearchStatus::AtLimit : TipSearchStatus::NoConvergence, task_.maxIterations};
}

Eigen::VectorXd DampedTipSearch::step(const Eigen::Vector3d &error, ConfigurationRef q, bool withNullMotion)
{
    tipJacobian(arm_, placement_, task_.link, jacobian_);
    jacobian_ = jacobian_ * units_.asDiagonal();
    if (!withNullMotion)
        return dampedStep<3>(jacobian_, error, damping_);
    options_.nullMotion(q, placement_, motion_);
    motion_ = motion_.cwiseQuotient(units_);
    return motion_ + dampedStep<3>(jacobian_, error - jacobian_ * motion_, damping_);
}
}  // namespace narrows
