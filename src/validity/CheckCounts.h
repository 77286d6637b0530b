// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace narrows
{
/// What checking has cost so far, free of any clock. Atomic, because some planners check from several threads.
struct CheckCounts
{
    std::atomic<std::uint64_t> stateChecks{0};   ///< states a planner asked about
    std::atomic<std::uint64_t> motionChecks{0};  ///< motions a planner asked about
    std::atomic<std::uint64_t> placements{0};    ///< configurations examined for either
};
}  // namespace narrows
