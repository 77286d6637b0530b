// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/ResultStore.h"

#include <filesystem>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <ompl/base/PlannerStatus.h>
#include <nlohmann/json.hpp>

#include "benchmark/Metrics.h"
#include "benchmark/ResultFile.h"
#include "benchmark/Sha256.h"
#include "benchmark/Text.h"

namespace narrows
{
void refuse(const std::string &path, const std::string &reason)
{
    throw InputError({{path, 0, "", reason}});
}

namespace
{
constexpr int schemaVersion = 1;
constexpr int applicationId = 0x4e525753;  // "NRWS": tells our databases from those of OMPL's own scripts

/// OMPL's tables (as ompl_benchmark_statistics makes them; parameters of an experiment begin at column 13) and ours.
/// The views are those by which Planner Arena picks a planner's best settings.
constexpr const char *tables = R"(
CREATE TABLE experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) UNIQUE,
  totaltime REAL, timelimit REAL, memorylimit REAL, runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024),
  cpuinfo TEXT, date DATETIME, seed VARCHAR(24), setup TEXT, scenario TEXT, checker TEXT, motion TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL, settings TEXT,
  UNIQUE (name, settings));
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY (name, value));
CREATE TABLE progress (runid INTEGER REFERENCES runs(id) ON DELETE CASCADE, time REAL, PRIMARY KEY (runid, time));
CREATE TABLE campaign (name TEXT NOT NULL, configuration TEXT NOT NULL, digest TEXT NOT NULL, seed INTEGER NOT NULL,
  engine TEXT NOT NULL);
CREATE TABLE instances (experimentid INTEGER PRIMARY KEY REFERENCES experiments(id) ON DELETE CASCADE,
  scenario TEXT NOT NULL, sha256 TEXT NOT NULL, options TEXT NOT NULL);
CREATE TABLE paths (runid INTEGER PRIMARY KEY REFERENCES runs(id) ON DELETE CASCADE, angles TEXT NOT NULL);
CREATE VIEW bestPlannerConfigsPerExperiment AS
  SELECT plannerid, experimentid, MIN(avg_solved) AS avg_solved, avg_total_time FROM
    (SELECT plannerid, name, experimentid, AVG(solved) AS avg_solved, AVG(time + simplification_time) AS avg_total_time
     FROM runs JOIN plannerConfigs ON plannerConfigs.id = plannerid GROUP BY plannerid, experimentid)
  GROUP BY name, experimentid ORDER BY avg_solved DESC, avg_total_time ASC;
CREATE VIEW bestPlannerConfigs AS
  SELECT plannerid, MIN(avg_solved) AS avg_solved, avg_total_time FROM
    (SELECT plannerid, name, AVG(solved) AS avg_solved, AVG(time + simplification_time) AS avg_total_time
     FROM runs JOIN plannerConfigs ON plannerConfigs.id = plannerid GROUP BY plannerid)
  GROUP BY name ORDER BY avg_solved DESC, avg_total_time ASC;
)";

std::string runsTable()
{
    std::string text =
        "CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, "
        "experimentid INTEGER NOT NULL REFERENCES experiments(id) ON DELETE CASCADE, "
        "plannerid INTEGER NOT NULL REFERENCES plannerConfigs(id) ON DELETE CASCADE";
    for (const Metric &metric : metrics())
        text += ", " + metric.name + " " + metric.type;
    return text + ", environmentid INTEGER REFERENCES environments(id), UNIQUE (experimentid, plannerid, run));";
}

}  // namespace

namespace
{
std::set<std::string> columnsOf(SQLite::Database &database, const std::string &table)
{
    std::set<std::string> present;
    SQLite::Statement query(database, "SELECT name FROM pragma_table_info(?)");
    query.bind(1, table);
    while (query.executeStep())
        present.insert(query.getColumn(0).getString());
    return present;
}
}  // namespace

std::set<std::string> runColumns(SQLite::Database &database)
{
    return columnsOf(database, "runs");
}

void addNewColumns(SQLite::Database &database)
{
    const std::set<std::string> known = runColumns(database);
    for (const Metric &metric : metrics())
        if (known.count(metric.name) == 0)
            database.exec("ALTER TABLE runs ADD COLUMN " + metric.name + " " + metric.type);
    const std::set<std::string> facts = columnsOf(database, "environments");
    for (const auto &[name, value] : captureEnvironment(0).facts)
        if (facts.count(name) == 0)
            database.exec("ALTER TABLE environments ADD COLUMN " + name + " TEXT");
}

namespace
{
std::string environmentsTable()
{
    std::string text = "CREATE TABLE environments (id INTEGER PRIMARY KEY, date DATETIME";
    for (const auto &[name, value] : captureEnvironment(0).facts)
        text += ", " + name + " TEXT";
    return text + ");";
}

void insertEnums(SQLite::Database &database)
{
    for (int value = 0; value < ob::PlannerStatus::TYPE_COUNT; ++value)
    {
        SQLite::Statement insert(database, "INSERT INTO enums VALUES ('status', ?, ?)");
        insert.bind(1, value);
        insert.bind(2, ob::PlannerStatus(static_cast<ob::PlannerStatus::StatusType>(value)).asString());
        insert.exec();
    }
}

void setUp(SQLite::Database &database)
{
    database.setBusyTimeout(10000);
    database.exec("PRAGMA foreign_keys = ON");
}

}  // namespace

std::unique_ptr<SQLite::Database> openOurs(const std::string &path, int mode)
{
    if (!std::filesystem::is_regular_file(path))
        refuse(path, "there is no such database");
    try
    {
        auto database = std::make_unique<SQLite::Database>(path, mode);
        setUp(*database);
        if (database->execAndGet("PRAGMA application_id").getInt() != applicationId)
            refuse(path, "is a database, but none that `narrows bench` made");
        const int version = database->execAndGet("PRAGMA user_version").getInt();
        if (version != schemaVersion)
            refuse(path, "has schema version " + std::to_string(version) + "; this program reads version " +
                             std::to_string(schemaVersion));
        const std::string verdict = database->execAndGet("PRAGMA integrity_check(1)").getString();
        if (verdict != "ok")
            refuse(path, "is damaged (" + trimmed(verdict) + ")");
        return database;
    }
    catch (const SQLite::Exception &error)
    {
        refuse(path, std::string("cannot be read as a database: ") + error.what());
    }
}

namespace
{
void requireSame(const std::string &path, SQLite::Database &database, const Experiment &experiment,
                 const std::string &engine)
{
    SQLite::Statement query(database, "SELECT configuration, digest, engine FROM campaign");
    if (!query.executeStep())
        refuse(path, "holds no campaign");
    requireSameHypotheses(path, database, experiment.hypotheses);
    if (query.getColumn(0).getString() != experiment.text)
        refuse(path, "holds another campaign: " + experiment.file + " is not what it was when this database was begun");
    if (query.getColumn(1).getString() != experiment.digest())
        refuse(path, "holds another campaign: a scenario of " + experiment.file + " has changed since");
    if (query.getColumn(2).getString() != engine)
        refuse(path, "was begun with --engine " + query.getColumn(2).getString());
}
}  // namespace

std::string settingsText(const RunSpec &spec)
{
    std::string text = "planner=" + spec.planner + ";space=" + spec.problem.space +
                       ";recipe=" + (spec.recipe ? "scenario" : "none") + ";";
    for (const auto &[name, value] : spec.parameters)
        text += name + "=" + value + ";";
    return text;
}

ResultStore::ResultStore(std::unique_ptr<SQLite::Database> database) : database_(std::move(database))
{
}
ResultStore::ResultStore(ResultStore &&other) noexcept = default;
ResultStore &ResultStore::operator=(ResultStore &&other) noexcept = default;
ResultStore::~ResultStore() = default;

bool ResultStore::isBlank(const std::string &path)
{
    try
    {
        SQLite::Database database(path, SQLite::OPEN_READWRITE);
        return database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0 &&
               database.execAndGet("PRAGMA application_id").getInt() == 0;
    }
    catch (const SQLite::Exception &)
    {
        return false;
    }
}

ResultStore ResultStore::create(const std::string &path, const Experiment &experiment, const std::string &engine)
{
    if (std::filesystem::exists(path) && !isBlank(path))
        refuse(path, "exists already; nothing was overwritten. --resume goes on with it, --db names another file");
    std::error_code ignored;  // opening the file reports what is wrong with its folder
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    try
    {
        ResultStore store(std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE));
        setUp(*store.database_);
        store.database_->exec("PRAGMA journal_mode = WAL");
        SQLite::Transaction transaction(*store.database_);
        store.database_->exec(tables + runsTable() + environmentsTable());
        store.database_->exec("PRAGMA application_id = " + std::to_string(applicationId));
        store.database_->exec("PRAGMA user_version = " + std::to_string(schemaVersion));
        addDeclarationTables(*store.database_);
        insertEnums(*store.database_);
        SQLite::Statement insert(*store.database_, "INSERT INTO campaign VALUES (?, ?, ?, ?, ?)");
        SQLite::bind(insert, experiment.name, experiment.text, experiment.digest(), experiment.seed, engine);
        insert.exec();
        insertHypotheses(*store.database_, experiment.hypotheses);
        store.insertInstances(experiment);
        transaction.commit();
        return store;
    }
    catch (const SQLite::Exception &error)
    {
        refuse(path, std::string("cannot be made: ") + error.what());
    }
}

ResultStore ResultStore::resume(const std::string &path, const Experiment &experiment, const std::string &engine)
{
    ResultStore store(openOurs(path, SQLite::OPEN_READWRITE));
    requireSame(path, *store.database_, experiment, engine);
    addNewColumns(*store.database_);
    addDeclarationTables(*store.database_);
    return store;
}

ResultStore ResultStore::open(const std::string &path)
{
    // Not opened read-only: the last to close a database with a write-ahead log tidies it up, which takes the right to
    // write.
    ResultStore store(openOurs(path, SQLite::OPEN_READWRITE));
    store.database_->exec("PRAGMA query_only = ON");
    return store;
}

void ResultStore::insertInstances(const Experiment &experiment)
{
    const Environment environment = captureEnvironment(experiment.jobs);
    std::set<std::string> seen;
    for (const RunSpec &spec : expand(experiment))
    {
        if (!seen.insert(spec.instance).second)
            continue;
        const Scenario &scenario = *spec.scenario;
        SQLite::Statement insert(*database_,
                                 "INSERT INTO experiments VALUES "
                                 "(NULL, ?, 0, ?, ?, ?, ?, ?, ?, datetime('now'), ?, ?, ?, ?, ?)");
        SQLite::bind(insert, spec.instance, spec.timeLimit, spec.memoryLimit, experiment.runCount, omplVersion(),
                     environment.hostname, environment.cpu, std::to_string(experiment.seed),
                     experiment.name + ": " + scenario.name + (scenario.source.empty() ? "" : ", " + scenario.source),
                     scenario.name, spec.problem.checker, spec.problem.motion);
        insert.exec();
        nlohmann::json options{{"group", spec.group},
                               {"checker", spec.problem.checker},
                               {"motion", spec.problem.motion},
                               {"simplify", spec.simplify},
                               {"warm_up", spec.warmUp},
                               {"time_limit", spec.timeLimit},
                               {"mem_limit", spec.memoryLimit},
                               {"grace", spec.grace},
                               {"state_check_limit", spec.stateCheckLimit},
                               {"evaluation_limit", spec.evaluationLimit}};
        if (spec.limits)
            options["limits"] = {spec.limits->velocity, spec.limits->acceleration, spec.limits->jerk};
        SQLite::Statement instance(*database_, "INSERT INTO instances VALUES (last_insert_rowid(), ?, ?, ?)");
        SQLite::bind(instance, scenario.text, sha256(scenario.text), options.dump());
        instance.exec();
    }
}

void ResultStore::beginSession(const Environment &environment)
{
    std::string names = "date";
    std::string marks = "datetime('now')";
    for (const auto &[name, value] : environment.facts)
    {
        names += ", " + name;
        marks += ", ?";
    }
    environment_ = writeTo(*database_,
                           [&]
                           {
                               SQLite::Statement insert(
                                   *database_, "INSERT INTO environments (" + names + ") VALUES (" + marks + ")");
                               for (std::size_t i = 0; i < environment.facts.size(); ++i)
                                   insert.bind(static_cast<int>(i) + 1, environment.facts[i].second);
                               insert.exec();
                               return database_->getLastInsertRowid();
                           });
}

void ResultStore::endSession(double seconds)
{
    writeTo(*database_,
            [&]
            {
                SQLite::Statement update(*database_, "UPDATE experiments SET totaltime = totaltime + ?");
                update.bind(1, seconds);
                update.exec();
            });
}
}  // namespace narrows
