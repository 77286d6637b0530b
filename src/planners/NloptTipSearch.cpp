// SPDX-License-Identifier: BSD-3-Clause
#include "planners/NloptTipSearch.h"

#include "planners/NloptProgram.h"

namespace narrows
{
using Eigen::VectorXd;

NloptTipSearch::NloptTipSearch(std::shared_ptr<const SpatialPoles> poles, TipSearchTask task,
                               const NloptOptions &options)
  : task_(std::move(task)), program_(std::make_unique<NloptProgram>(std::move(poles), task_, options))
{
}

NloptTipSearch::~NloptTipSearch() = default;

TipSearchResult NloptTipSearch::reach(const Eigen::Vector3d &target, VectorXd &q)
{
    program_->begin(target, q);
    VectorXd x = VectorXd::Zero(q.size());
    double least = 0.0;
    // Whatever it returns, rounding included: what counts is where the tip is.
    nlopt_optimize(program_->optimizer, x.data(), &least);
    const int evaluations = nlopt_get_numevals(program_->optimizer);
    if (!x.allFinite())
        return {TipSearchStatus::NoConvergence, evaluations};
    program_->place(x.data());
    q = program_->q;
    if (task_.enforceLimits(q))
    {
        x = (q - program_->origin).cwiseQuotient(program_->units);
        program_->place(x.data());
    }
    if (program_->tipError() <= task_.precision)
        return {TipSearchStatus::Reached, evaluations};
    return {program_->touchesLimit() ? TipSearchStatus::AtLimit : TipSearchStatus::NoConvergence, evaluations};
}
}  // namespace narrows
