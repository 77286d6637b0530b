// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
/// What the paper prints of a trajectory, Eq. 10 (with n_v^{a_v} where it prints n_v^a).
struct PaperLogs
{
    double viaLog;   ///< zeta_v = t_v - log_nv(|S_v - q_0| |n_v^t_v - n_v^a_v|); infinite for S_v = q_0
    double goalLog;  ///< zeta = t_s - log_n(|S_f - S_v| |n^t_s - n^a|); infinite for S_v = S_f
};

/// \param feedback S_v
PaperLogs paperLogs(const ViaPointTask &task, const PaperParameters &parameters, double feedback);

/// Where the fixed point went.
struct IterationResult
{
    double feedback;  ///< S_v
    int steps;        ///< updates until S_v repeated itself exactly; that last one counts
    bool converged;   ///< S_v repeated itself within maxSteps
};

/// The paper's fixed point, Eqs. 9 and 10 as printed: zeta of S_v, S_v of zeta. It converges for K < 1 only, by the
/// factor K per step; ViaPointTrajectory::paper() has the limit in closed form. Kept to reproduce the paper's counts.
/// \pre ViaPointTrajectory::paper() accepts task and parameters, up to Singular
IterationResult iterateFeedback(const ViaPointTask &task, const PaperParameters &parameters, double first,
                                int maxSteps);
}  // namespace narrows
