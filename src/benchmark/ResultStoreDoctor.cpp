// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a database, and what one should know before reading its numbers.
#include <fmt/format.h>

#include "benchmark/ResultFile.h"
#include "benchmark/ResultStore.h"
#include "benchmark/Sha256.h"

namespace narrows
{
namespace
{
/// One text per row of a query with one column.
std::vector<std::string> texts(SQLite::Database &database, const std::string &query)
{
    SQLite::Statement statement(database, query);
    std::vector<std::string> result;
    while (statement.executeStep())
        result.push_back(statement.getColumn(0).getString());
    return result;
}

void addChangedScenarios(SQLite::Database &database, std::vector<std::string> &faults)
{
    SQLite::Statement query(database,
                            "SELECT name, instances.scenario, sha256 FROM instances "
                            "JOIN experiments ON experiments.id = experimentid ORDER BY name");
    while (query.executeStep())
        if (sha256(query.getColumn(1).getString()) != query.getColumn(2).getString())
            faults.push_back("the scenario of " + query.getColumn(0).getString() +
                             " is not the one that its SHA-256 was taken of");
}

void addChangedHypotheses(SQLite::Database &database, std::vector<std::string> &faults)
{
    if (!database.tableExists("hypotheses"))
        return;  // an older program made it
    SQLite::Statement query(database, "SELECT name, definition, sha256 FROM hypotheses ORDER BY name");
    while (query.executeStep())
        if (sha256(query.getColumn(1).getString()) != query.getColumn(2).getString())
            faults.push_back("the hypothesis " + query.getColumn(0).getString() +
                             " is not the one that its SHA-256 was taken of");
}

Diagnosis diagnose(SQLite::Database &database)
{
    Diagnosis diagnosis;
    for (const std::string &table : texts(database, "SELECT DISTINCT \"table\" FROM pragma_foreign_key_check()"))
        diagnosis.faults.push_back("rows of " + table + " refer to rows that are not there");
    addChangedScenarios(database, diagnosis.faults);
    addChangedHypotheses(database, diagnosis.faults);
    for (const std::string &run : texts(database, "SELECT id FROM runs WHERE solved AND NOT coalesce(verified, 0)"))
        diagnosis.faults.push_back("run " + run + " counts as solved, though no verifier accepted it");
    for (const std::string &run : texts(database, "SELECT id FROM runs WHERE (outcome = 'solved') IS NOT (solved = 1)"))
        diagnosis.faults.push_back("run " + run + " contradicts itself: outcome and solved differ");
    for (const std::string &run : texts(database,
                                        "SELECT runs.id FROM runs JOIN instances USING (experimentid) WHERE solved AND "
                                        "instr(scenario, char(10) || 'infeasible:') > 0"))
        diagnosis.faults.push_back("run " + run + " counts as solved, though its scenario is proven to have no way");

    for (const std::string &line : texts(database, R"(
             SELECT experiments.name || ', ' || plannerConfigs.name || ': ' || count(*) || ' of ' || runcount || ' runs'
             FROM runs JOIN experiments ON experiments.id = experimentid
               JOIN plannerConfigs ON plannerConfigs.id = plannerid
             GROUP BY experimentid, plannerid HAVING count(*) < runcount ORDER BY 1)"))
        diagnosis.notes.push_back(line);
    for (const std::string &name : texts(database,
                                         "SELECT name FROM experiments WHERE id NOT IN (SELECT "
                                         "experimentid FROM runs) ORDER BY name"))
        diagnosis.notes.push_back(name + ": no runs");
    for (const char *fact : {"git_commit", "compiler", "flags", "cpu", "ompl", "fcl"})
    {
        const auto values = texts(database, fmt::format("SELECT DISTINCT {} FROM environments WHERE id IN (SELECT "
                                                        "environmentid FROM runs) ORDER BY 1",
                                                        fact));
        if (values.size() > 1)
            diagnosis.notes.push_back(
                fmt::format("measured in {} environments that differ in {}", values.size(), fact));
    }
    if (!texts(database, "SELECT id FROM environments WHERE git_dirty = '1'").empty())
        diagnosis.notes.push_back("measured by a program with changes that its commit does not have");
    return diagnosis;
}
}  // namespace

Diagnosis ResultStore::examine() const
{
    return readFrom(*database_, [this] { return diagnose(*database_); });
}
}  // namespace narrows
