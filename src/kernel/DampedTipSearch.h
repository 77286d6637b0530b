// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/TipSearch.h"

namespace narrows
{
/// A motion, per joint, that the arm would like to make apart from its tip; in the arm's own units.
using NullMotion =
    std::function<void(ConfigurationRef q, const SpatialArm::Placement &placement, Eigen::VectorXd &motion)>;

/// How the search steps and when it gives up.
struct DampedTipSearchOptions
{
    double lambda = 0.003;  ///< damping, >= 0, as a share of the arm's reach
    NullMotion nullMotion;  ///< may be unset
    int nullSteps = 1;      ///< iterations that it takes part in
};

/// Damped least squares and, with a null motion, gradient projection (Liegeois 1977): every step is the damped answer
/// to the error of the tip plus what the tip leaves of the null motion, (1 - J^# J) motion.
class DampedTipSearch : public TipSearch
{
public:
    /// \param task what the tip is asked for
    DampedTipSearch(const SpatialArm &arm, TipSearchTask task, DampedTipSearchOptions options);

    TipSearchResult reach(const Eigen::Vector3d &target, Eigen::VectorXd &q) override;

private:
    /// In units of the search.
    Eigen::VectorXd step(const Eigen::Vector3d &error, ConfigurationRef q, bool withNullMotion);

    SpatialArm arm_;
    TipSearchTask task_;
    DampedTipSearchOptions options_;
    Eigen::VectorXd units_;
    double damping_;
    SpatialArm::Placement placement_;
    Eigen::Matrix3Xd jacobian_;
    Eigen::VectorXd motion_;
};
}  // namespace narrows
