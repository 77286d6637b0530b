// SPDX-License-Identifier: BSD-3-Clause
// The rows of a ResultStore: one run in, many runs out.
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <nlohmann/json.hpp>

#include "benchmark/Metrics.h"
#include "benchmark/ResultFile.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
void bindCell(SQLite::Statement &statement, int index, const Cell &cell)
{
    if (const auto *integer = std::get_if<std::int64_t>(&cell))
        statement.bind(index, *integer);
    else if (const auto *real = std::get_if<double>(&cell))
        statement.bind(index, *real);
    else if (const auto *text = std::get_if<std::string>(&cell))
        statement.bind(index, *text);
    else
        statement.bind(index);
}

Cell cellOf(const SQLite::Column &column)
{
    if (column.isNull())
        return {};
    if (column.isInteger())
        return static_cast<std::int64_t>(column.getInt64());
    if (column.isFloat())
        return column.getDouble();
    return column.getString();
}

/// What settingsText() wrote, as the spec's own. A value may hold ";", but no piece of one looks like name=value.
void applySettings(const std::string &settings, RunSpec &spec)
{
    std::map<std::string, std::string> values;
    std::string name;
    std::istringstream pieces(settings);
    for (std::string piece; std::getline(pieces, piece, ';');)
    {
        const std::size_t equals = piece.find('=');
        if (equals == std::string::npos)
        {
            values[name] += ";" + piece;
            continue;
        }
        name = piece.substr(0, equals);
        values[name] = piece.substr(equals + 1);
    }
    const auto take = [&](const char *key)
    {
        const auto node = values.extract(key);
        return node ? node.mapped() : std::string();
    };
    spec.planner = take("planner");
    spec.problem.space = take("space");
    spec.recipe = take("recipe") != "none";
    spec.parameters = std::move(values);
}

std::optional<double> optionalNumber(const SQLite::Column &column)
{
    return column.isNull() ? std::nullopt : std::optional<double>(column.getDouble());
}

std::string pathText(const std::vector<Eigen::VectorXd> &path)
{
    nlohmann::json rows = nlohmann::json::array();
    for (const Eigen::VectorXd &row : path)
        rows.push_back(std::vector<double>(row.begin(), row.end()));
    return rows.dump();
}

std::vector<Eigen::VectorXd> pathFromText(const std::string &text)
{
    std::vector<Eigen::VectorXd> path;
    for (const nlohmann::json &row : nlohmann::json::parse(text))
    {
        Eigen::VectorXd waypoint(static_cast<Eigen::Index>(row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)  // JSON says null for what is not finite
            waypoint[static_cast<Eigen::Index>(i)] = row[i].is_null() ? std::nan("") : row[i].get<double>();
        path.push_back(waypoint);
    }
    return path;
}
}  // namespace

void ResultStore::add(const RunSpec &spec, const Record &record, SavePaths savePaths)
{
    SQLite::Transaction transaction(*database_);
    const std::int64_t id = insertRun(spec, record);
    if (savePaths != SavePaths::None && !record.path.empty())
        savePath(id, record, savePaths);
    transaction.commit();
}

std::int64_t ResultStore::plannerId(const RunSpec &spec)
{
    const std::string settings = settingsText(spec);
    SQLite::Statement insert(*database_, "INSERT OR IGNORE INTO plannerConfigs VALUES (NULL, ?, ?)");
    SQLite::bind(insert, spec.label, settings);
    insert.exec();
    SQLite::Statement query(*database_, "SELECT id FROM plannerConfigs WHERE name = ? AND settings = ?");
    SQLite::bind(query, spec.label, settings);
    query.executeStep();
    return query.getColumn(0).getInt64();
}

std::int64_t ResultStore::insertRun(const RunSpec &spec, const Record &record)
{
    const std::int64_t planner = plannerId(spec);
    const int count = static_cast<int>(metrics().size());
    // By name, because a database that an older program began has the newest metrics at its end.
    std::string names = "experimentid, plannerid";
    std::string marks = "(SELECT id FROM experiments WHERE name = ?), ?";
    for (const Metric &metric : metrics())
    {
        names += ", " + metric.name;
        marks += ", ?";
    }
    SQLite::Statement insert(*database_, "INSERT INTO runs (" + names + ", environmentid) VALUES (" + marks + ", ?)");
    insert.bind(1, spec.instance);
    insert.bind(2, planner);
    for (int i = 0; i < count; ++i)
        bindCell(insert, i + 3, metrics()[static_cast<std::size_t>(i)].value(spec, record));
    insert.bind(count + 3, environment_);
    insert.exec();
    return database_->getLastInsertRowid();
}

void ResultStore::savePath(std::int64_t runId, const Record &record, SavePaths savePaths)
{
    SQLite::Statement insert(*database_, "INSERT INTO paths VALUES (?, ?)");
    SQLite::bind(insert, runId, pathText(record.path));
    insert.exec();
    if (savePaths == SavePaths::All)
        return;
    // The shortest of those that count; equal ones by their run, so that the order in which runs end does not matter.
    SQLite::Statement prune(*database_, R"(
        WITH rivals AS (SELECT other.id, other.solved, other.solution_length, other.run FROM runs AS other JOIN runs AS mine
          ON other.experimentid = mine.experimentid AND other.plannerid = mine.plannerid
          WHERE mine.id = ? AND other.id IN (SELECT runid FROM paths))
        DELETE FROM paths WHERE runid IN (SELECT id FROM rivals) AND runid NOT IN
          (SELECT id FROM rivals WHERE solved ORDER BY solution_length, run LIMIT 1))");
    prune.bind(1, runId);
    prune.exec();
}

std::vector<RunSpec> ResultStore::missing(const std::vector<RunSpec> &specs) const
{
    std::set<std::tuple<std::string, std::string, std::string, int>> done;
    for (const RunRow &row : runs())
        done.emplace(row.instance, row.label, row.settings, row.run);
    std::vector<RunSpec> result;
    for (const RunSpec &spec : specs)
        if (done.count({spec.instance, spec.label, settingsText(spec), spec.run}) == 0)
            result.push_back(spec);
    return result;
}

std::vector<RunRow> ResultStore::runs() const
{
    SQLite::Statement query(*database_, R"(
        SELECT experiments.name, plannerConfigs.name, settings, run, outcome, reason, prescribed, cpu_time, evaluations,
          state_checks, solution_length, solution_clearance, coalesce(json_extract(options, '$.group'), experiments.name)
        FROM runs JOIN experiments ON experiments.id = runs.experimentid
          JOIN instances ON instances.experimentid = runs.experimentid
          JOIN plannerConfigs ON plannerConfigs.id = plannerid
        ORDER BY experiments.id, plannerConfigs.name, settings, run)");
    std::vector<RunRow> rows;
    while (query.executeStep())
    {
        RunRow row;
        row.instance = query.getColumn(0).getString();
        row.label = query.getColumn(1).getString();
        row.settings = query.getColumn(2).getString();
        row.run = query.getColumn(3).getInt();
        row.outcome = outcomeFromString(query.getColumn(4).getString());
        row.reason = query.getColumn(5).getString();
        row.prescribed = query.getColumn(6).getInt() != 0;
        row.cpuTime = optionalNumber(query.getColumn(7));
        row.evaluations = optionalNumber(query.getColumn(8));
        row.stateChecks = optionalNumber(query.getColumn(9));
        row.length = optionalNumber(query.getColumn(10));
        row.clearance = optionalNumber(query.getColumn(11));
        row.group = query.getColumn(12).getString();
        rows.push_back(row);
    }
    return rows;
}

StoredRun ResultStore::run(std::int64_t id) const
{
    std::string columns;
    std::vector<std::string> known;
    const std::set<std::string> present = runColumns(*database_);
    for (const Metric &metric : metrics())
        if (present.count(metric.name) != 0)
        {
            known.push_back(metric.name);
            columns += ", runs." + metric.name;
        }
    SQLite::Statement query(*database_, R"(
        SELECT experiments.name, plannerConfigs.name, settings, checker, motion, experiments.scenario,
          instances.scenario, options, angles)" +
                                            columns + R"(
        FROM runs JOIN experiments ON experiments.id = runs.experimentid
          JOIN instances ON instances.experimentid = runs.experimentid
          JOIN plannerConfigs ON plannerConfigs.id = plannerid LEFT JOIN paths ON runid = runs.id WHERE runs.id = ?)");
    query.bind(1, id);
    if (!query.executeStep())
        throw std::invalid_argument("there is no run " + std::to_string(id) + " in this database");
    StoredRun stored;
    for (const std::string &name : known)
        stored.cells[name] = cellOf(query.getColumn(name.c_str()));

    RunSpec &spec = stored.spec;
    applySettings(query.getColumn(2).getString(), spec);
    spec.instance = query.getColumn(0).getString();
    spec.label = query.getColumn(1).getString();
    spec.problem.checker = query.getColumn(3).getString();
    spec.problem.motion = query.getColumn(4).getString();
    spec.scenario =
        std::make_shared<const Scenario>(parseScenario(query.getColumn(6).getString(), query.getColumn(5).getString()));
    const nlohmann::json options = nlohmann::json::parse(query.getColumn(7).getString());
    spec.group = options.value("group", spec.instance);
    spec.simplify = options.at("simplify").get<bool>();
    spec.warmUp = options.at("warm_up").get<double>();
    if (options.contains("limits"))
        spec.limits = MotionLimits{options.at("limits").at(0), options.at("limits").at(1), options.at("limits").at(2)};
    spec.timeLimit = options.at("time_limit").get<double>();
    spec.memoryLimit = options.at("mem_limit").get<double>();
    spec.run = static_cast<int>(std::get<std::int64_t>(stored.cells.at("run")));
    spec.seed = static_cast<std::uint32_t>(std::get<std::int64_t>(stored.cells.at("seed")));
    if (!query.getColumn(8).isNull())
        stored.path = pathFromText(query.getColumn(8).getString());
    return stored;
}

void ResultStore::eachPath(const std::function<void(const PathRow &)> &visit) const
{
    SQLite::Statement query(*database_, R"(
        SELECT experiments.name, plannerConfigs.name, run, solved, instances.scenario, experiments.scenario, angles
        FROM paths JOIN runs ON runs.id = runid JOIN experiments ON experiments.id = runs.experimentid
          JOIN instances ON instances.experimentid = runs.experimentid JOIN plannerConfigs ON plannerConfigs.id = plannerid
        ORDER BY experiments.id, plannerConfigs.name, run)");
    while (query.executeStep())
        visit({query.getColumn(0).getString(), query.getColumn(1).getString(), query.getColumn(2).getInt(),
               query.getColumn(3).getInt() != 0, query.getColumn(4).getString(), query.getColumn(5).getString(),
               pathFromText(query.getColumn(6).getString())});
}
}  // namespace narrows
