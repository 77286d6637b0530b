// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "benchmark/Record.h"

namespace narrows
{
/// The stages of a run that a supervisor needs to know: only Solving is under the time limit.
enum class RunStage
{
    Building,
    WarmUp,
    Solving,
    Judging  ///< simplification, verification, metrics
};

/// Does one run in this process: seed, build space, problem and planner anew, solve, verify, measure. The clock runs
/// around solve() only, with an in-line timed termination condition. Exceptions of the planner become outcomes; a crash
/// takes the process with it (see `runAll`).
/// \param onStage called when a stage begins
/// \throws std::invalid_argument for a mistake of the caller: no such planner, checker, space or parameter, or a value
/// that is refused while the planner is set up.
Record runOnce(const RunSpec &spec, const std::function<void(RunStage)> &onStage = {});
}  // namespace narrows
