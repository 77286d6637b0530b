// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
enum class SavePaths
{
    None,
    Shortest,  ///< of every instance and planner entry
    All
};

/// One entry of the [planner] section: a planner with its settings. The same planner may have several.
struct PlannerChoice
{
    std::string planner;            ///< name in the factory
    std::string label;              ///< how tables call it; two entries share one only if no scenario has both
    std::string space;              ///< as in ProblemOptions
    bool recipe = true;             ///< may it use the scenario's `methods`?
    std::vector<std::string> only;  ///< names, groups or bases of the scenarios it is for; empty: all
    std::map<std::string, std::string> parameters;

    bool isFor(const Scenario &scenario) const;
};

/// What a campaign is to decide, declared before its first run.
struct Hypothesis
{
    std::string name;                   ///< one word
    std::string statement;              ///< in words
    std::vector<std::string> planners;  ///< labels of entries, each of which must show it
    std::vector<std::string> against;   ///< labels of entries, against each of which; or none, and:
    std::optional<double> bound;        ///< what the quantity is compared with
    std::vector<std::string> groups;    ///< of instances
    std::string quantity;               ///< success | time (s) | evaluations | memory (KB) | length
    std::string direction;              ///< more | less: what the planners have, by the statement
};

struct Hypotheses
{
    double alpha = 0.05;  ///< chance to be wrong about any of them, all being decided at once
    std::vector<Hypothesis> all;
};

/// Typed copy of an experiment file (docs/experiments.md).
struct Experiment
{
    std::string file;  ///< path as it was given
    std::string text;  ///< the file as it was read
    std::string name;  ///< one word
    std::vector<std::shared_ptr<const Scenario>> scenarios;
    std::vector<std::string> checkers{"analytic"};
    std::vector<std::string> motions{"continuous"};
    double timeLimit = 10.0;           ///< seconds per run
    double memoryLimit = 1024.0;       ///< MB per run
    double grace = RunSpec().grace;    ///< seconds after the time limit until a run is killed
    std::int64_t stateCheckLimit = 0;  ///< per run; 0: none
    std::int64_t evaluationLimit = 0;  ///< per run; 0: none
    int runCount = 20;                 ///< per planner entry and instance
    std::uint32_t seed = 1;            ///< of the campaign; every run derives its own
    std::string output;                ///< folder for the database
    SavePaths savePaths = SavePaths::Shortest;
    bool simplify = false;
    std::optional<MotionLimits> limits;  ///< at which the solutions' durations are compared
    double warmUp = 0.02;                ///< seconds, untimed, before every run
    int jobs = 1;                        ///< runs at a time
    bool pin = true;                     ///< keep every run to physical cores of its own
    int canary = 0;                      ///< runs between two runs of the canary (Canary.h); 0: none
    std::vector<PlannerChoice> planners;
    Hypotheses hypotheses;

    /// Where results go unless told otherwise: <output>/<file's stem>.db
    std::string databasePath() const;
    /// SHA-256 over all that decides which runs there are: this file and its scenarios.
    std::string digest() const;
};

/// \throws InputError with all faults of the file and of the scenarios it names, unknown planners and parameters
/// included.
Experiment readExperiment(const std::string &path);

/// The same for text that is already in memory; scenarios are looked for beside `path`.
/// \param mostScenes that one scenario file may make by a sweep: more is a slip of the pen
Experiment parseExperiment(const std::string &text, const std::string &path, int mostScenes = 100000);

/// All runs in the order they shall be done: run 0 of all instances, then run 1, ... The planners of one instance and
/// run follow each other in an order drawn from the seed, so that a drift of the machine's speed hits all of them
/// alike. Every run's seed is a hash of all that identifies it: a run can be repeated alone, and adding a planner
/// changes no other.
std::vector<RunSpec> expand(const Experiment &experiment);

/// A part of a campaign's runs, for several machines.
struct Shard
{
    int index = 1;  ///< in [1, count]
    int count = 1;
};

/// "2/8" as a shard.
/// \throws std::invalid_argument for any other text
Shard shardFromText(const std::string &text);

/// The runs of one shard, in their order. The planners of one instance and run stay together, so that what is compared
/// is measured on one machine; such blocks are dealt out in turn, those of one instance to different shards. Every run
/// belongs to exactly one shard of `count`.
std::vector<RunSpec> runsOf(const Shard &shard, const std::vector<RunSpec> &specs);
}  // namespace narrows
