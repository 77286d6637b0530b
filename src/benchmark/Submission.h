// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "benchmark/ShardFolder.h"

namespace narrows
{
struct SubmissionOptions
{
    std::string engine = "local";  ///< slurm: an array of jobs | parallel: GNU parallel | local: one after another
    int shards = 8;
    int jobs = 0;                      ///< shards at a time (parallel, slurm); 0: as many as the engine likes
    int minutes = 0;                   ///< after which Slurm ends a shard; 0: its own default
    std::vector<std::string> options;  ///< for sbatch, one `#SBATCH` line each
    bool unlike = false;               ///< merge although shards were measured in unlike environments
};

struct SubmissionResult
{
    std::size_t submitted = 0;  ///< shards that were not complete
    std::string job;            ///< Slurm's number of the array; empty for engines that wait until all is done
};

/// Hands the shards that are not complete to an engine that others have built. Those that wait (parallel, local) return
/// when it is done; Slurm goes on by itself and merges when every shard has ended.
/// \throws std::invalid_argument if the engine's programs are missing or refuse; InputError as ShardFolder does
SubmissionResult submit(const Experiment &experiment, const SubmissionOptions &options);

/// What Slurm says of the shards that it still has, by index ("RUNNING", ...); empty for all others, or without Slurm.
std::vector<std::string> slurmStates(const ShardFolder &folder);
}  // namespace narrows
