// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
/// The same run in every campaign: RRT-Connect, always the same seed, on a scene of the family `slab`. It always does
/// the same (some ten milliseconds of collision checking), so that its CPU time tells how fast the machine was, and the
/// number of its checks whether the program is what it was.
RunSpec canaryRun();

/// What to do, in turn: the indices of `count` runs, nothing for a canary. There is one before the first run, one after
/// the last, and one whenever `interval` runs have gone by since the last one; none at all if the interval is 0.
std::vector<std::optional<std::size_t>> withCanaries(std::size_t count, std::size_t interval);
}  // namespace narrows
