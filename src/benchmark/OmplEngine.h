// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
/// Does the runs as OMPL users know it: with `ompl::tools::Benchmark`, in this process. There is one benchmark, and one
/// of OMPL's logs, for all runs of an instance that share the problem, the limits and the number of runs per planner
/// entry. A run's properties and its record get our verdict and counts beside OMPL's own figures.
///
/// What this engine cannot do, as it is OMPL's: a planner that crashes takes all with it, one that ignores the limit is
/// waited for, planners and space are used again by the next run, and there is one seed per benchmark. That seed is the
/// group's first spec's and stands in the record as the measure `process_seed`; the specs' own seeds mean nothing here.
/// `time` and `simplificationTime` are OMPL's wall times; memory is not recorded, because OMPL's is the whole
/// process's.
///
/// \param logPathPrefix logs are written to <prefix><instance>[-<n>].log
/// \param onRecord called with the index of the spec when its record is complete
/// \return the paths of the logs
/// \throws std::invalid_argument for a spec that cannot be built; std::runtime_error if a log cannot be written.
std::vector<std::string> runOmplBenchmark(const std::vector<RunSpec> &specs, const std::string &logPathPrefix,
                                          const std::function<void(std::size_t, const Record &)> &onRecord);
}  // namespace narrows
