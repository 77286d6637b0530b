// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/Experiment.h"

namespace narrows
{
/// How far one shard of a campaign is.
struct ShardState
{
    int index = 1;  ///< from 1
    std::size_t planned = 0;
    std::size_t done = 0;
    std::string trouble;  ///< why its database cannot be read; empty if it can, or if there is none yet
    bool complete() const { return trouble.empty() && done == planned; }
};

/// Where the shards of a campaign lie that `narrows submit` has begun: `NAME.shards` beside the campaign's database,
/// with a database and the output of each shard and the script that does one.
class ShardFolder
{
public:
    /// Begins a folder, or goes on with one.
    /// \throws InputError if a folder is there with another number of shards, or it cannot be written
    static ShardFolder begin(const Experiment &experiment, int count);
    /// \throws InputError if `narrows submit` has begun none
    static ShardFolder open(const Experiment &experiment);

    int count() const { return count_; }
    const std::string &path() const { return path_; }
    std::string database(int shard) const;
    /// Where a shard's output goes.
    std::string output(int shard) const;
    std::string file(const std::string &name) const { return path_ + "/" + name; }

    /// By index. A shard that is being done is read as it is now.
    std::vector<ShardState> states() const;

    /// Joins all shards into the campaign's database.
    /// \param unlike as for ResultStore::merge()
    /// \return false if it is there already
    /// \throws InputError as ResultStore::merge() does
    bool merge(bool unlike) const;

private:
    ShardFolder(const Experiment &experiment, std::string path, int count);

    const Experiment &experiment_;
    std::string path_;
    int count_;
};
}  // namespace narrows
