// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/Environment.h"
#include "benchmark/Experiment.h"

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

/// The database of one campaign: OMPL's benchmark tables with OMPL's columns, and ours (docs/database.md). This is the
/// only place that knows SQL. Every run is added in a transaction of its own, so that a killed campaign loses none that
/// it had finished.
class ResultStore
{
public:
    /// A new database.
    /// \throws InputError if the file exists or cannot be made.
    static ResultStore create(const std::string &path, const Experiment &experiment, const std::string &engine);
    /// The database of a campaign that was interrupted.
    /// \throws InputError if it is damaged, not ours, or of another campaign (experiment file, scenario, engine).
    static ResultStore resume(const std::string &path, const Experiment &experiment, const std::string &engine);
    /// For reading.
    /// \throws InputError if there is no such file or it is damaged, not ours, or of a newer version of this program.
    static ResultStore open(const std::string &path);

    ResultStore(ResultStore &&other) noexcept;
    ResultStore &operator=(ResultStore &&other) noexcept;
    ~ResultStore();

    /// Says where the runs that follow are done.
    void beginSession(const Environment &environment);
    /// \throws std::runtime_error if there is such a run already.
    void add(const RunSpec &spec, const Record &record, SavePaths savePaths);
    /// Books a session's duration on all experiments.
    void endSession(double seconds);

    /// The runs of the list that have no row yet, in its order.
    std::vector<RunSpec> missing(const std::vector<RunSpec> &specs) const;
    /// Ordered by instance, label and run.
    std::vector<RunRow> runs() const;
    void eachPath(const std::function<void(const PathRow &)> &visit) const;

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
