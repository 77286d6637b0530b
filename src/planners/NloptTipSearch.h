// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/SpatialPoles.h"
#include "kernel/TipSearch.h"

namespace narrows
{
/// How the optimization is done, and what of.
struct NloptOptions
{
    bool withoutDerivatives = false;  ///< COBYLA instead of SLSQP
    double margin = 0.0;              ///< >= 0, a length: least clearance that the posture is asked to have
};

struct NloptProgram;

/// The posture nearest to where the search begins whose tip is at the target, within the limits of joints and universal
/// joints and clear of obstacles (and of itself, if the poles have pairs of links), by NLopt. Limits that NLopt's
/// answer misses by rounding are enforced afterwards.
class NloptTipSearch : public TipSearch
{
public:
    /// \param poles of the arm among its obstacles
    /// \param task its maxIterations are evaluations; COBYLA gets (joints + 1) times as many
    /// \param options method and margin
    NloptTipSearch(std::shared_ptr<const SpatialPoles> poles, TipSearchTask task, const NloptOptions &options);
    ~NloptTipSearch() override;

    /// Deterministic. Reached says nothing of obstacles: the posture that NLopt ends in may touch them.
    TipSearchResult reach(const Eigen::Vector3d &target, Eigen::VectorXd &q) override;

private:
    TipSearchTask task_;
    std::unique_ptr<NloptProgram> program_;
};
}  // namespace narrows
