// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmark/ResultStore.h"

namespace narrows
{
/// What a second look at the paths of a database found.
struct RecheckResult
{
    std::int64_t accepted = 0;  ///< paths that the campaign's verifier had accepted, and that were looked at again
    std::int64_t refused = 0;   ///< paths it had refused
    std::int64_t states = 0;    ///< configurations examined by the dense resampling
    std::vector<std::string>
        refutations;  ///< one line per accepted path that fails now, and per refused one accepted now
};

/// Verifies every stored path again and, if it was accepted, samples it so densely that no point of the arm moves more
/// than `step` between two samples, asking the analytic checker about each of them.
/// \throws std::invalid_argument unless step > 0
RecheckResult recheck(const ResultStore &store, double step);
}  // namespace narrows
