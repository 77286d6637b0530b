// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/Cores.h"
#include "benchmark/Record.h"
#include "benchmark/RunOnce.h"

namespace narrows
{
/// What a run's process writes to its supervisor: one letter when a stage begins, and in the end `resultMark` followed
/// by the record as JSON.
constexpr char resultMark = 'R';
char toMark(RunStage stage);

/// The descriptors that a run's process is given.
struct ChildPipes
{
    int result;  ///< where marks and record go
    int output;  ///< where the run's stdout and stderr go
};

/// The whole life of a run's process, right after fork(): puts limits on itself, does the run, sends the record, exits.
/// Nothing may come back from here into the supervisor's code.
/// \param cpus to keep to; none: any
/// \param supervisor process id of the parent; if it is gone, so is this process
[[noreturn]] void liveAsRun(const RunSpec &spec, const ChildPipes &pipes, const CpuList &cpus, int supervisor) noexcept;
}  // namespace narrows
