// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/Environment.h"
#include "benchmark/Experiment.h"
#include "benchmark/Metrics.h"

namespace SQLite
{
class Database;
}

namespace narrows
{
/// What tables need to know of a run.
struct RunRow
{
    std::string instance;
    std::string group;  ///< of instances that differ in the seed of a sweep only
    std::string label;
    std::string settings;  ///< of the planner entry
    int run = 0;
    Outcome outcome = Outcome::InternalError;
    std::string reason;
    bool prescribed = false;
    std::optional<double> cpuTime;  ///< seconds
    std::optional<double> evaluations;
    std::optional<double> stateChecks;
    std::optional<double> length;
    std::optional<double> clearance;
};

/// A stored path and the scenario it was planned in.
struct PathRow
{
    std::string instance;
    std::string label;
    int run = 0;
    bool verified = false;
    std::string scenarioText;
    std::string scenarioName;
    std::vector<Eigen::VectorXd> path;  ///< in the scenario's own convention
};

/// A run as it was planned and what is stored of it.
struct StoredRun
{
    RunSpec spec;
    std::map<std::string, Cell> cells;  ///< of `runs` by column; metrics only
    std::vector<Eigen::VectorXd> path;  ///< in the scenario's own convention; empty if none was kept
};

/// What is to be said of a database.
struct Diagnosis
{
    std::vector<std::string> faults;  ///< things that should never be: numbers from it cannot be trusted
    std::vector<std::string> notes;   ///< things to know before reading numbers: runs that are missing, a tree with
                                      ///< changes that no commit has, unlike machines
};

/// The database of one campaign: OMPL's benchmark tables with OMPL's columns, and ours (docs/database.md). This is the
/// only place that knows SQL. Every run is added in a transaction of its own, so that a killed campaign loses none that
/// it had finished.
class ResultStore
{
public:
    /// A new database.
    /// \throws InputError if the file exists, unless it is blank, or cannot be made.
    static ResultStore create(const std::string &path, const Experiment &experiment, const std::string &engine);
    /// Is the file a database without anything in it? So it is left by a campaign that was killed while it made it.
    static bool isBlank(const std::string &path);
    /// The database of a campaign that was interrupted.
    /// \throws InputError if it is damaged, not ours, or of another campaign (experiment file, scenario, engine).
    static ResultStore resume(const std::string &path, const Experiment &experiment, const std::string &engine);
    /// For reading.
    /// \throws InputError if there is no such file or it is damaged, not ours, or of a newer version of this program.
    static ResultStore open(const std::string &path);

    /// A new database with the runs of several that hold parts of one campaign (shards). The parts stay as they are;
    /// nothing is left behind if it fails.
    /// \param unlike also if the parts were measured in environments that differ (commit, compiler, CPU, libraries)
    /// \throws InputError naming the part if the file exists, a part is not sound or of another campaign, two parts
    /// hold the same run, or, without `unlike`, their environments differ.
    static ResultStore merge(const std::string &path, const std::vector<std::string> &parts, bool unlike = false);

    ResultStore(ResultStore &&other) noexcept;
    ResultStore &operator=(ResultStore &&other) noexcept;
    ~ResultStore();

    /// Says where the runs that follow are done.
    void beginSession(const Environment &environment);
    /// \throws InputError if it cannot be written: no room, or there is such a run already. Nothing of it is stored
    /// then.
    void add(const RunSpec &spec, const Record &record, SavePaths savePaths);
    /// Adds a run of the canary (Canary.h), which is none of the campaign's.
    void addCanary(const Record &record);
    /// Books a session's duration on all experiments.
    void endSession(double seconds);

    /// The runs of the list that have no row yet, in its order.
    std::vector<RunSpec> missing(const std::vector<RunSpec> &specs) const;
    /// Ordered by instance, label and run. What reads throws InputError if somebody else has written into the database.
    std::vector<RunRow> runs() const;
    void eachPath(const std::function<void(const PathRow &)> &visit) const;
    /// \param id of the table `runs`
    /// \throws std::invalid_argument if there is no such run
    StoredRun run(std::int64_t id) const;
    /// Looks for what should not be: rows that refer to nothing, scenarios that are not what they were, ...
    Diagnosis examine() const;

private:
    explicit ResultStore(std::unique_ptr<SQLite::Database> database);

    void insertInstances(const Experiment &experiment);
    std::int64_t plannerId(const RunSpec &spec);
    std::int64_t insertRun(const RunSpec &spec, const Record &record);
    void savePath(std::int64_t runId, const Record &record, SavePaths savePaths);

    std::unique_ptr<SQLite::Database> database_;
    std::int64_t environment_ = 0;
};

/// All that tells a planner entry apart from others, on one line.
std::string settingsText(const RunSpec &spec);
}  // namespace narrows
