// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/ShardFolder.h"

#include <filesystem>

#include <fmt/format.h>

#include "benchmark/ResultStore.h"
#include "benchmark/Text.h"
#include "scenario/InputText.h"

namespace narrows
{
namespace
{
constexpr const char *countFile = "shards";

std::string folderOf(const Experiment &experiment)
{
    return std::filesystem::absolute(experiment.databasePath()).replace_extension(".shards").string();
}

int storedCount(const std::string &folder)
{
    const std::string file = folder + "/" + countFile;
    const std::optional<double> count = toNumber(trimmed(readInputText(file)));
    if (!count || *count < 1.0 || *count != static_cast<int>(*count))
        throw InputError({{file, 1, "", "does not say how many shards there are"}});
    return static_cast<int>(*count);
}
}  // namespace

ShardFolder::ShardFolder(const Experiment &experiment, std::string path, int count)
  : experiment_(experiment), path_(std::move(path)), count_(count)
{
}

ShardFolder ShardFolder::begin(const Experiment &experiment, int count)
{
    const std::string folder = folderOf(experiment);
    if (std::filesystem::exists(folder + "/" + countFile))
    {
        const int before = storedCount(folder);
        if (before != count)
            throw InputError({{folder, 0, "", fmt::format("was begun with {} shards, not {}", before, count)}});
        return {experiment, folder, count};
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError({{folder, 0, "", "cannot be made: " + error.message()}});
    writeFile(folder + "/" + countFile, std::to_string(count) + "\n");
    return {experiment, folder, count};
}

ShardFolder ShardFolder::open(const Experiment &experiment)
{
    const std::string folder = folderOf(experiment);
    if (!std::filesystem::exists(folder + "/" + countFile))
        throw InputError({{folder, 0, "", "is not there: `narrows submit` has not begun this experiment"}});
    return {experiment, folder, storedCount(folder)};
}

std::string ShardFolder::database(int shard) const
{
    return file(fmt::format("shard-{}.db", shard));
}

std::string ShardFolder::output(int shard) const
{
    return file(fmt::format("shard-{}.out", shard));
}

std::vector<ShardState> ShardFolder::states() const
{
    const std::vector<RunSpec> all = expand(experiment_);
    std::vector<ShardState> states;
    for (int shard = 1; shard <= count_; ++shard)
    {
        const std::vector<RunSpec> mine = runsOf({shard, count_}, all);
        ShardState state;
        state.index = shard;
        state.planned = mine.size();
        if (std::filesystem::exists(database(shard)) && !ResultStore::isBlank(database(shard)))
            try
            {
                state.done = mine.size() - ResultStore::open(database(shard)).missing(mine).size();
            }
            catch (const InputError &error)
            {
                state.trouble = error.faults().front().reason;
            }
        states.push_back(state);
    }
    return states;
}

bool ShardFolder::merge(bool unlike) const
{
    if (std::filesystem::exists(experiment_.databasePath()))
        return false;
    std::vector<std::string> parts;
    for (const ShardState &state : states())
        if (state.planned > 0)
            parts.push_back(database(state.index));
    ResultStore::merge(experiment_.databasePath(), parts, unlike);
    return true;
}
}  // namespace narrows
