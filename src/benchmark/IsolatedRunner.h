// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
/// Does many runs, each in a process of its own, at most `jobs` at a time, started in the given order. Every spec
/// yields exactly one record, whatever the planner does: throws, aborts, segfaults, eats memory, ignores the limit,
/// floods its output, exits silently. A run that somebody else kills is done again, up to three times. Whatever a run
/// has started is gone when its record arrives. Call from a process without other threads. \param onRecord called in
/// this process as runs end (any order), with the index of the spec \param stop polled between events; true kills the
/// runs in flight (they get no record) and returns \param pin keeps every run to physical cores of its own; without it
/// the system moves runs about. Either way, records say whether two runs may have shared a core: with more jobs than
/// cores they must. \throws std::invalid_argument before the first run if jobs < 1 or a spec names no planner there is.
void runAll(const std::vector<RunSpec> &specs, int jobs,
            const std::function<void(std::size_t, const Record &)> &onRecord, const std::function<bool()> &stop = {},
            bool pin = false);
}  // namespace narrows
