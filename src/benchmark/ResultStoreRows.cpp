// SPDX-License-Identifier: BSD-3-Clause
// What a ResultStore writes of a run, and which runs it lacks.
#include <set>
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

std::string pathText(const std::vector<Eigen::VectorXd> &path)
{
    nlohmann::json rows = nlohmann::json::array();
    for (const Eigen::VectorXd &row : path)
        rows.push_back(std::vector<double>(row.begin(), row.end()));
    return rows.dump();
}
}  // namespace

void ResultStore::add(const RunSpec &spec, const Record &record, SavePaths savePaths)
{
    writeTo(*database_,
            [&]
            {
                SQLite::Transaction transaction(*database_);
                const std::int64_t id = insertRun(spec, record);
                if (savePaths != SavePaths::None && !record.path.empty())
                    savePath(id, record, savePaths);
                transaction.commit();
            });
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
}  // namespace narrows
