// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Experiment.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "benchmark/Sha256.h"

namespace narrows
{
namespace
{
/// The first 32 bits of the hash; never 0, which OMPL takes for "none".
std::uint32_t runSeed(const Experiment &experiment, const RunSpec &spec)
{
    std::string identity = std::to_string(experiment.seed) + "|" + spec.instance + "|" + spec.planner + "|" +
                           spec.label + "|" + spec.problem.space + "|";
    for (const auto &[name, value] : spec.parameters)
        identity += name + "=" + value + ",";
    identity += "|" + std::to_string(spec.run);
    const auto seed = static_cast<std::uint32_t>(std::stoul(sha256(identity).substr(0, 8), nullptr, 16));
    return std::max<std::uint32_t>(seed, 1);
}

/// An instance without planner and run.
struct Instance
{
    std::string name;
    std::string group;
    std::shared_ptr<const Scenario> scenario;
    ProblemOptions problem;
};

std::vector<Instance> instances(const Experiment &experiment)
{
    std::vector<Instance> all;
    const bool namesMotion = experiment.motions.size() > 1 || experiment.motions.front() != "continuous";
    for (const auto &scenario : experiment.scenarios)
        for (const std::string &checker : experiment.checkers)
            for (const std::string &motion : experiment.motions)
            {
                ProblemOptions problem;
                problem.checker = checker;
                problem.motion = motion;
                const std::string suffix = "_" + checker + (namesMotion ? "_" + motion : "");
                all.push_back({scenario->name + suffix, scenario->group + suffix, scenario, problem});
            }
    return all;
}

RunSpec makeSpec(const Experiment &experiment, const Instance &instance, const PlannerChoice &choice, int run)
{
    RunSpec spec;
    spec.instance = instance.name;
    spec.group = instance.group;
    spec.scenario = instance.scenario;
    spec.problem = instance.problem;
    spec.problem.space = choice.space;
    spec.planner = choice.planner;
    spec.label = choice.label;
    spec.parameters = choice.parameters;
    spec.recipe = choice.recipe;
    spec.run = run;
    spec.timeLimit = experiment.timeLimit;
    spec.memoryLimit = experiment.memoryLimit;
    spec.grace = experiment.grace;
    spec.stateCheckLimit = experiment.stateCheckLimit;
    spec.evaluationLimit = experiment.evaluationLimit;
    spec.simplify = experiment.simplify;
    spec.limits = experiment.limits;
    spec.warmUp = experiment.warmUp;
    spec.seed = runSeed(experiment, spec);
    return spec;
}
}  // namespace

bool PlannerChoice::isFor(const Scenario &scenario) const
{
    return only.empty() ||
           std::any_of(only.begin(), only.end(), [&](const std::string &word) { return scenario.isCalled(word); });
}

std::string Experiment::databasePath() const
{
    return (std::filesystem::path(output) / std::filesystem::path(file).stem()).string() + ".db";
}

std::string Experiment::digest() const
{
    std::string hashes = sha256(text);
    for (const auto &scenario : scenarios)
        hashes += sha256(scenario->text);
    return sha256(hashes);
}

std::vector<RunSpec> expand(const Experiment &experiment)
{
    std::vector<RunSpec> specs;
    for (int run = 0; run < experiment.runCount; ++run)
        for (const Instance &instance : instances(experiment))
        {
            const auto begin = static_cast<std::ptrdiff_t>(specs.size());
            for (const PlannerChoice &choice : experiment.planners)
                if (choice.isFor(*instance.scenario))
                    specs.push_back(makeSpec(experiment, instance, choice, run));
            // The seeds are hashes: sorting by them is a shuffle that any machine repeats.
            std::stable_sort(specs.begin() + begin, specs.end(),
                             [](const RunSpec &a, const RunSpec &b) { return a.seed < b.seed; });
        }
    return specs;
}

Shard shardFromText(const std::string &text)
{
    Shard shard;
    const std::size_t slash = text.find('/');
    const char *const end = text.data() + text.size();
    const auto readsTo = [](const char *from, const char *to, int &value)
    {
        const auto [stop, error] = std::from_chars(from, to, value);
        return error == std::errc{} && stop == to;
    };
    if (slash == std::string::npos || !readsTo(text.data(), text.data() + slash, shard.index) ||
        !readsTo(text.data() + slash + 1, end, shard.count) || shard.index < 1 || shard.index > shard.count)
        throw std::invalid_argument("a shard is written i/n with 1 <= i <= n, not \"" + text + "\"");
    return shard;
}

std::vector<RunSpec> runsOf(const Shard &shard, const std::vector<RunSpec> &specs)
{
    // Dealt out instance by instance: in the order of the runs, as many shards as instances would give each machine an
    // instance of its own.
    std::map<std::string, std::set<int>> blocks;
    for (const RunSpec &spec : specs)
        blocks[spec.instance].insert(spec.run);
    std::set<std::pair<std::string, int>> mine;
    int turn = 0;
    for (const auto &[instance, runs] : blocks)
        for (const int run : runs)
            if (turn++ % shard.count == shard.index - 1)
                mine.emplace(instance, run);

    std::vector<RunSpec> result;
    for (const RunSpec &spec : specs)
        if (mine.count({spec.instance, spec.run}) != 0)
            result.push_back(spec);
    return result;
}
}  // namespace narrows
