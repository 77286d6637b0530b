// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Submission.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/Cores.h"
#include "benchmark/Plugins.h"
#include "benchmark/Subprocess.h"
#include "benchmark/Text.h"
#include "scenario/InputText.h"

namespace narrows
{
namespace
{
/// As one word of a shell.
std::string quoted(const std::string &text)
{
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

/// This very program with its plugins, for a shell.
std::string programText()
{
    std::string text = quoted(std::filesystem::read_symlink("/proc/self/exe").string());
    for (const LoadedPlugin &plugin : loadedPlugins())
        text += " --plugin " + quoted(plugin.path);
    return text;
}

/// A script that does the shard of its first argument, on the share of the machine that the second one names, if any.
std::string writeShardScript(const Experiment &experiment, const ShardFolder &folder)
{
    const std::string script = folder.file("run-shard");
    writeFile(
        script,
        fmt::format("#!/bin/sh\nexec {} bench {} --shard \"$1/{}\" --db {}\"$1.db\" --jobs 1 --resume ${{2:+--slot "
                    "\"$2\"}} >>{}\"$1.out\" 2>&1\n",
                    programText(), quoted(std::filesystem::absolute(experiment.file).string()), folder.count(),
                    quoted(folder.file("shard-")), quoted(folder.file("shard-"))));
    std::filesystem::permissions(script, std::filesystem::perms::owner_exec, std::filesystem::perm_options::add);
    return script;
}

std::vector<int> incompleteShards(const ShardFolder &folder)
{
    std::vector<int> shards;
    const std::vector<std::string> queued = slurmStates(folder);
    for (const ShardState &state : folder.states())
        if (!state.complete() && queued[static_cast<std::size_t>(state.index) - 1].empty())
            shards.push_back(state.index);
    return shards;
}

std::vector<std::string> asWords(const std::vector<int> &shards)
{
    std::vector<std::string> words;
    for (const int shard : shards)
        words.push_back(std::to_string(shard));
    return words;
}

void runLocally(const std::string &script, const std::vector<int> &shards)
{
    for (const std::string &shard : asWords(shards))
        runProgram({script, shard});  // what it leaves undone is seen by the folder's states
}

void runInParallel(const ShardFolder &folder, const std::string &script, const std::vector<int> &shards, int jobs)
{
    const int slots = std::max(1, std::min<int>(jobs > 0 ? jobs : static_cast<int>(usablePhysicalCores().size()),
                                                static_cast<int>(shards.size())));
    // Its --joblog tells of signals and times; which shards are complete is for their databases to say.
    std::vector<std::string> words{
        "parallel", "--jobs", std::to_string(slots),          "--joblog", folder.file("parallel.log"),
        script,     "{}",     fmt::format("{{%}}/{}", slots), ":::"};
    for (const std::string &shard : asWords(shards))
        words.push_back(shard);
    if (runProgram(words) == 127)
        throw std::invalid_argument("GNU parallel cannot be started; on Debian: apt-get install parallel");
}

std::string submitJob(const std::vector<std::string> &words, const std::string &script)
{
    std::vector<std::string> command{"sbatch", "--parsable"};
    command.insert(command.end(), words.begin(), words.end());
    command.push_back(script);
    const ProgramOutput output = outputOf(command);
    if (output.exitCode == 127)
        throw std::invalid_argument("sbatch cannot be started; is Slurm installed?");
    const std::string job = trimmed(output.text.substr(0, output.text.find(';')));
    if (output.exitCode != 0 || job.empty())
    {
        runProgram(command);  // says on stderr why
        throw std::invalid_argument("sbatch refuses " + script);
    }
    return job;
}

/// The array, and a job after it that merges.
std::string submitToSlurm(const Experiment &experiment, const ShardFolder &folder, const std::string &script,
                          const std::vector<int> &shards, const SubmissionOptions &options)
{
    std::string header = "#!/bin/sh\n#SBATCH --job-name=" + experiment.name + "\n#SBATCH --cpus-per-task=1\n";
    for (const std::string &option : options.options)
        header += "#SBATCH " + option + "\n";
    const std::string limit = options.minutes > 0 ? fmt::format("#SBATCH --time={}\n", options.minutes) : "";
    const std::string atATime = options.jobs > 0 ? fmt::format("%{}", options.jobs) : "";
    writeFile(folder.file("array.sh"), header + limit + "exec " + quoted(script) + " \"$SLURM_ARRAY_TASK_ID\"\n");
    writeFile(folder.file("merge.sh"), fmt::format("{}exec {} status {}{}\n", header, programText(),
                                                   quoted(std::filesystem::absolute(experiment.file).string()),
                                                   options.unlike ? " --unlike" : ""));
    const std::string job = submitJob({"--array=" + joined(asWords(shards), ",") + atATime,
                                       "--output=" + folder.file("slurm-%a.out"), "--open-mode=append"},
                                      folder.file("array.sh"));
    writeFile(folder.file("slurm-job"), job + "\n");
    submitJob({"--dependency=afterany:" + job, "--output=" + folder.file("merge.out")}, folder.file("merge.sh"));
    return job;
}
}  // namespace

SubmissionResult submit(const Experiment &experiment, const SubmissionOptions &options)
{
    const ShardFolder folder = ShardFolder::begin(experiment, options.shards);
    const std::string script = writeShardScript(experiment, folder);
    const std::vector<int> shards = incompleteShards(folder);
    SubmissionResult result;
    result.submitted = shards.size();
    if (shards.empty())
        return result;
    if (options.engine == "slurm")
        result.job = submitToSlurm(experiment, folder, script, shards, options);
    else if (options.engine == "parallel")
        runInParallel(folder, script, shards, options.jobs);
    else
        runLocally(script, shards);
    return result;
}

std::vector<std::string> slurmStates(const ShardFolder &folder)
{
    std::vector<std::string> states(static_cast<std::size_t>(folder.count()));
    if (!std::filesystem::exists(folder.file("slurm-job")))
        return states;
    const std::string job = trimmed(readInputText(folder.file("slurm-job")));
    std::istringstream lines(outputOf({"squeue", "--noheader", "--array", "--jobs=" + job, "--format=%K %T"}).text);
    int shard = 0;
    for (std::string state; lines >> shard >> state;)
        if (shard >= 1 && shard <= folder.count())
            states[static_cast<std::size_t>(shard) - 1] = state;
    return states;
}
}  // namespace narrows
