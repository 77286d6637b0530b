// SPDX-License-Identifier: BSD-3-Clause
// What a campaign declares before its runs, and the canary's runs among them.
#include <map>

#include <SQLiteCpp/VariadicBind.h>

#include "benchmark/Hypothesis.h"
#include "benchmark/ResultFile.h"
#include "benchmark/ResultStore.h"
#include "benchmark/Sha256.h"

namespace narrows
{
void addDeclarationTables(SQLite::Database &database)
{
    database.exec(R"(
CREATE TABLE IF NOT EXISTS hypotheses (name TEXT PRIMARY KEY, definition TEXT NOT NULL, sha256 TEXT NOT NULL,
  declared DATETIME NOT NULL);
CREATE TABLE IF NOT EXISTS canaries (id INTEGER PRIMARY KEY, environmentid INTEGER REFERENCES environments(id),
  date DATETIME NOT NULL, cpu_time REAL, state_checks INTEGER, outcome TEXT NOT NULL);
)");
}

void insertHypotheses(SQLite::Database &database, const Hypotheses &hypotheses)
{
    for (const Hypothesis &hypothesis : hypotheses.all)
    {
        const std::string definition = toJson(hypothesis, hypotheses.alpha);
        SQLite::Statement insert(database, "INSERT INTO hypotheses VALUES (?, ?, ?, datetime('now'))");
        SQLite::bind(insert, hypothesis.name, definition, sha256(definition));
        insert.exec();
    }
}

void requireSameHypotheses(const std::string &path, SQLite::Database &database, const Hypotheses &hypotheses)
{
    if (!database.tableExists("hypotheses"))
        return;  // an older program began it: its file can have declared none
    std::map<std::string, std::string> declared;
    SQLite::Statement query(database, "SELECT name, sha256 FROM hypotheses");
    while (query.executeStep())
        declared[query.getColumn(0).getString()] = query.getColumn(1).getString();
    const std::string advice = "; what was declared before the runs cannot be changed after them";
    for (const Hypothesis &hypothesis : hypotheses.all)
    {
        const auto stored = declared.extract(hypothesis.name);
        if (!stored)
            refuse(path, "does not have the hypothesis '" + hypothesis.name + "'" + advice);
        if (stored.mapped() != sha256(toJson(hypothesis, hypotheses.alpha)))
            refuse(path, "has another hypothesis '" + hypothesis.name + "'" + advice);
    }
    if (!declared.empty())
        refuse(path, "has the hypothesis '" + declared.begin()->first + "', which the file lacks" + advice);
}

void ResultStore::addCanary(const Record &record)
{
    SQLite::Statement insert(*database_, "INSERT INTO canaries VALUES (NULL, ?, datetime('now'), ?, ?, ?)");
    insert.bind(1, environment_);
    if (record.cpuTime)
        insert.bind(2, *record.cpuTime);
    if (record.stateChecks)
        insert.bind(3, *record.stateChecks);
    insert.bind(4, toString(record.outcome));
    insert.exec();
}
}  // namespace narrows
