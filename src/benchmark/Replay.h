// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmark/ResultStore.h"

namespace narrows
{
/// A cell that came out otherwise.
struct Deviation
{
    std::string column;  ///< of the table `runs`, or "path"
    std::string stored;  ///< for people
    std::string now;
};

struct ReplayResult
{
    RunSpec spec;
    Record record;                      ///< of the run just done
    std::vector<Deviation> deviations;  ///< times and memory left out
    bool threaded = false;              ///< the planner has threads of its own: it need not repeat itself
};

/// Does a stored run once more, alone, in a process of its own, and compares all that a seed decides.
/// \param id of the table `runs`
/// \throws std::invalid_argument if there is no such run
ReplayResult replay(const ResultStore &store, std::int64_t id);
}  // namespace narrows
