// SPDX-License-Identifier: BSD-3-Clause
// The tables of a database, and how one is known to be ours.
#include <filesystem>

#include <SQLiteCpp/SQLiteCpp.h>
#include <ompl/base/PlannerStatus.h>

#include "benchmark/Environment.h"
#include "benchmark/Metrics.h"
#include "benchmark/ResultFile.h"
#include "benchmark/Text.h"

namespace narrows
{
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

std::set<std::string> columnsOf(SQLite::Database &database, const std::string &table)
{
    std::set<std::string> present;
    SQLite::Statement query(database, "SELECT name FROM pragma_table_info(?)");
    query.bind(1, table);
    while (query.executeStep())
        present.insert(query.getColumn(0).getString());
    return present;
}

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
}  // namespace

void refuse(const std::string &path, const std::string &reason)
{
    throw InputError({{path, 0, "", reason}});
}

void setUp(SQLite::Database &database)
{
    database.setBusyTimeout(10000);
    database.exec("PRAGMA foreign_keys = ON");
}

void makeTables(SQLite::Database &database)
{
    database.exec(tables + runsTable() + environmentsTable());
    database.exec("PRAGMA application_id = " + std::to_string(applicationId));
    database.exec("PRAGMA user_version = " + std::to_string(schemaVersion));
    addDeclarationTables(database);
    insertEnums(database);
}

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
}  // namespace narrows
