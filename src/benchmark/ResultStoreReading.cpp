// SPDX-License-Identifier: BSD-3-Clause
// What can be read from a ResultStore: runs, a run as it was planned, paths.
#include <cmath>
#include <set>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <nlohmann/json.hpp>

#include "benchmark/Metrics.h"
#include "benchmark/ResultFile.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
constexpr double formerGrace = 0.5;  // seconds, of campaigns that do not say

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

RunRow rowOf(SQLite::Statement &query)
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
    return row;
}

/// What the campaign asked of all runs on an instance.
void applyOptions(const nlohmann::json &options, RunSpec &spec)
{
    spec.group = options.value("group", spec.instance);
    spec.simplify = options.at("simplify").get<bool>();
    spec.warmUp = options.at("warm_up").get<double>();
    if (options.contains("limits"))
        spec.limits = MotionLimits{options.at("limits").at(0), options.at("limits").at(1), options.at("limits").at(2)};
    spec.timeLimit = options.at("time_limit").get<double>();
    spec.memoryLimit = options.at("mem_limit").get<double>();
    spec.grace = options.value("grace", formerGrace);
    spec.stateCheckLimit = options.value("state_check_limit", std::int64_t{0});
    spec.evaluationLimit = options.value("evaluation_limit", std::int64_t{0});
}

/// The first columns of the statement of storedRun(), as the run's spec.
RunSpec specOf(SQLite::Statement &query, const std::map<std::string, Cell> &cells)
{
    RunSpec spec;
    applySettings(query.getColumn(2).getString(), spec);
    spec.instance = query.getColumn(0).getString();
    spec.label = query.getColumn(1).getString();
    spec.problem.checker = query.getColumn(3).getString();
    spec.problem.motion = query.getColumn(4).getString();
    spec.scenario =
        std::make_shared<const Scenario>(parseScenario(query.getColumn(6).getString(), query.getColumn(5).getString()));
    applyOptions(nlohmann::json::parse(query.getColumn(7).getString()), spec);
    spec.run = static_cast<int>(std::get<std::int64_t>(cells.at("run")));
    spec.seed = static_cast<std::uint32_t>(std::get<std::int64_t>(cells.at("seed")));
    return spec;
}

std::optional<StoredRun> storedRun(SQLite::Database &database, std::int64_t id)
{
    std::string columns;
    std::vector<std::string> known;
    const std::set<std::string> present = runColumns(database);
    for (const Metric &metric : metrics())
        if (present.count(metric.name) != 0)
        {
            known.push_back(metric.name);
            columns += ", runs." + metric.name;
        }
    SQLite::Statement query(database, R"(
        SELECT experiments.name, plannerConfigs.name, settings, checker, motion, experiments.scenario,
          instances.scenario, options, angles)" +
                                          columns + R"(
        FROM runs JOIN experiments ON experiments.id = runs.experimentid
          JOIN instances ON instances.experimentid = runs.experimentid
          JOIN plannerConfigs ON plannerConfigs.id = plannerid LEFT JOIN paths ON runid = runs.id WHERE runs.id = ?)");
    query.bind(1, id);
    if (!query.executeStep())
        return std::nullopt;
    StoredRun stored;
    for (const std::string &name : known)
        stored.cells[name] = cellOf(query.getColumn(name.c_str()));
    stored.spec = specOf(query, stored.cells);
    if (!query.getColumn(8).isNull())
        stored.path = pathFromText(query.getColumn(8).getString());
    return stored;
}
}  // namespace

std::vector<RunRow> ResultStore::runs() const
{
    return readFrom(*database_,
                    [this]
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
                            rows.push_back(rowOf(query));
                        return rows;
                    });
}

StoredRun ResultStore::run(std::int64_t id) const
{
    const std::optional<StoredRun> stored = readFrom(*database_, [this, id] { return storedRun(*database_, id); });
    if (!stored)
        throw std::invalid_argument("there is no run " + std::to_string(id) + " in this database");
    return *stored;
}

void ResultStore::eachPath(const std::function<void(const PathRow &)> &visit) const
{
    const char *const text = R"(
        SELECT experiments.name, plannerConfigs.name, run, solved, instances.scenario, experiments.scenario, angles
        FROM paths JOIN runs ON runs.id = runid JOIN experiments ON experiments.id = runs.experimentid
          JOIN instances ON instances.experimentid = runs.experimentid JOIN plannerConfigs ON plannerConfigs.id = plannerid
        ORDER BY experiments.id, plannerConfigs.name, run)";
    const auto query =
        readFrom(*database_, [this, text] { return std::make_unique<SQLite::Statement>(*database_, text); });
    const auto next = [&query]() -> std::optional<PathRow>
    {
        if (!query->executeStep())
            return std::nullopt;
        return PathRow{query->getColumn(0).getString(),
                       query->getColumn(1).getString(),
                       query->getColumn(2).getInt(),
                       query->getColumn(3).getInt() != 0,
                       query->getColumn(4).getString(),
                       query->getColumn(5).getString(),
                       pathFromText(query->getColumn(6).getString())};
    };
    while (const std::optional<PathRow> row = readFrom(*database_, next))
        visit(*row);
}
}  // namespace narrows
