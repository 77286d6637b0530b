// SPDX-License-Identifier: BSD-3-Clause
// Parts of one campaign become one database.
#include <algorithm>
#include <filesystem>
#include <set>

#include <SQLiteCpp/VariadicBind.h>

#include "benchmark/Environment.h"
#include "benchmark/IniFile.h"
#include "benchmark/Metrics.h"
#include "benchmark/ResultFile.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
/// The campaign's row, as one text.
std::string campaignOf(SQLite::Database &database)
{
    SQLite::Statement query(database, "SELECT configuration, digest, seed, engine FROM campaign");
    std::string text;
    if (query.executeStep())
        for (int i = 0; i < query.getColumnCount(); ++i)
            text += query.getColumn(i).getString() + "\n";
    return text;
}

/// Facts that differ from session to session on one machine and say nothing against comparing its runs.
bool mayDiffer(const std::string &fact)
{
    return fact == "jobs" || fact == "load_average" || fact == "usable_cores";
}

std::string factNames(const std::string &separator)
{
    std::string names;
    for (const auto &[name, value] : captureEnvironment(0).facts)
        names += (names.empty() ? "" : separator) + name;
    return names;
}

/// "cpu: A | B", for every fact that is not the same in all sessions.
std::vector<std::string> differingFacts(SQLite::Database &database)
{
    std::vector<std::string> differences;
    for (const auto &[name, value] : captureEnvironment(0).facts)
    {
        if (mayDiffer(name))
            continue;
        SQLite::Statement query(database, "SELECT count(DISTINCT " + name + "), group_concat(DISTINCT " + name +
                                              ") FROM environments WHERE id IN (SELECT environmentid FROM runs)");
        query.executeStep();
        if (query.getColumn(0).getInt() > 1)
            differences.push_back(name + ": " + query.getColumn(1).getString());
    }
    return differences;
}

/// A run that both the database and its attached part hold; empty if there is none.
std::string sharedRun(SQLite::Database &database)
{
    SQLite::Statement query(database, R"(
        SELECT e.name || ', ' || c.name || ', run ' || r.run FROM part.runs AS r
          JOIN part.experiments AS e ON e.id = r.experimentid JOIN part.plannerConfigs AS c ON c.id = r.plannerid
          JOIN main.experiments AS e2 ON e2.name = e.name
          JOIN main.plannerConfigs AS c2 ON c2.name = c.name AND c2.settings = c.settings
          JOIN main.runs AS r2 ON r2.experimentid = e2.id AND r2.plannerid = c2.id AND r2.run = r.run LIMIT 1)");
    return query.executeStep() ? query.getColumn(0).getString() : "";
}

std::int64_t largestId(SQLite::Database &database, const std::string &table)
{
    return database.execAndGet("SELECT coalesce(max(id), 0) FROM main." + table).getInt64();
}

/// Adds what the attached part holds.
void addPart(SQLite::Database &database)
{
    const std::string runs = std::to_string(largestId(database, "runs"));
    const std::string environments = std::to_string(largestId(database, "environments"));
    std::string names, values;
    for (const Metric &metric : metrics())
    {
        names += metric.name + ", ";
        values += "r." + metric.name + ", ";
    }
    const std::string facts = factNames(", ");
    database.exec(
        "INSERT OR IGNORE INTO main.plannerConfigs (name, settings) "
        "SELECT name, settings FROM part.plannerConfigs ORDER BY id");
    database.exec("INSERT INTO main.environments (id, date, " + facts + ") SELECT id + " + environments + ", date, " +
                  facts + " FROM part.environments");
    database.exec("INSERT INTO main.runs (id, experimentid, plannerid, " + names + "environmentid) SELECT r.id + " +
                  runs + ", e2.id, c2.id, " + values + "r.environmentid + " + environments +
                  R"( FROM part.runs AS r JOIN part.experiments AS e ON e.id = r.experimentid
                      JOIN main.experiments AS e2 ON e2.name = e.name
                      JOIN part.plannerConfigs AS c ON c.id = r.plannerid
                      JOIN main.plannerConfigs AS c2 ON c2.name = c.name AND c2.settings = c.settings)");
    database.exec(
        "INSERT INTO main.canaries (environmentid, date, cpu_time, state_checks, outcome) SELECT environmentid + " +
        environments + ", date, cpu_time, state_checks, outcome FROM part.canaries ORDER BY id");
    database.exec("INSERT INTO main.paths (runid, angles) SELECT runid + " + runs + ", angles FROM part.paths");
    database.exec(
        "UPDATE main.experiments SET totaltime = totaltime + coalesce((SELECT p.totaltime FROM "
        "part.experiments AS p WHERE p.name = main.experiments.name), 0)");
}

bool keepsShortestOnly(SQLite::Database &database)
{
    std::vector<InputFault> ignored;  // it was read without faults when the campaign began
    const std::string text = database.execAndGet("SELECT configuration FROM campaign").getString();
    std::string kept = "shortest";
    for (const IniEntry &entry : parseIni(text, "", ignored))
        if (entry.section == "benchmark" && entry.key == "save_paths")
            kept = entry.value;
    return kept == "shortest";
}

/// Several parts have each kept their shortest path.
void keepShortest(SQLite::Database &database)
{
    database.exec(R"(
        DELETE FROM paths WHERE runid NOT IN (SELECT id FROM (SELECT runs.id, row_number() OVER
          (PARTITION BY experimentid, plannerid ORDER BY solved DESC, solution_length, run) AS place
          FROM runs JOIN paths ON runid = runs.id) WHERE place = 1))");
}

void attach(SQLite::Database &database, const std::string &part)
{
    SQLite::Statement statement(database, "ATTACH DATABASE ? AS part");
    statement.bind(1, part);
    statement.exec();
}

/// A part that has all of today's columns, in a file of its own beside the result.
std::string upToDateCopy(const std::string &part, const std::string &copy)
{
    const auto source = openOurs(part, SQLite::OPEN_READWRITE);
    SQLite::Statement statement(*source, "VACUUM INTO ?");
    statement.bind(1, copy);
    statement.exec();
    const auto database = openOurs(copy, SQLite::OPEN_READWRITE);
    addNewColumns(*database);
    addDeclarationTables(*database);
    return campaignOf(*source);
}

/// Files that are gone when this is.
class Scratch
{
public:
    explicit Scratch(std::string stem) : stem_(std::move(stem)) { removeAll(); }
    ~Scratch() { removeAll(); }
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    std::string whole() const { return stem_ + ".merging"; }
    std::string part() const { return stem_ + ".merging-part"; }
    void removePart() const { remove(part()); }

private:
    static void remove(const std::string &file)
    {
        std::error_code ignored;
        for (const char *suffix : {"", "-wal", "-shm", "-journal"})
            std::filesystem::remove(file + suffix, ignored);
    }
    void removeAll() const
    {
        remove(whole());
        remove(part());
    }

    std::string stem_;
};

void join(const Scratch &scratch, const std::vector<std::string> &parts, bool unlike)
{
    const std::string campaign = upToDateCopy(parts.front(), scratch.whole());
    const auto whole = openOurs(scratch.whole(), SQLite::OPEN_READWRITE);
    for (auto part = parts.begin() + 1; part != parts.end(); ++part)
    {
        scratch.removePart();
        if (upToDateCopy(*part, scratch.part()) != campaign)
            refuse(*part, "is of another campaign than " + parts.front());
        attach(*whole, scratch.part());
        const std::string twice = sharedRun(*whole);
        if (!twice.empty())
            refuse(*part, "holds a run that another part holds too: " + twice);
        SQLite::Transaction transaction(*whole);
        addPart(*whole);
        transaction.commit();
        whole->exec("DETACH DATABASE part");
    }
    const std::vector<std::string> differences = differingFacts(*whole);
    if (!differences.empty() && !unlike)
        refuse(parts.back(), "or another part was measured in an unlike environment (" + differences.front() +
                                 "); --unlike merges them all the same");
    if (keepsShortestOnly(*whole))
        keepShortest(*whole);
    whole->exec("PRAGMA journal_mode = WAL");
}
}  // namespace

ResultStore ResultStore::merge(const std::string &path, const std::vector<std::string> &parts, bool unlike)
{
    if (parts.empty())
        throw std::invalid_argument("merge: no database is given");
    if (std::filesystem::exists(path))
        refuse(path, "exists already; nothing was overwritten");
    try
    {
        const Scratch scratch(path);
        join(scratch, parts, unlike);
        std::filesystem::rename(scratch.whole(), path);
    }
    catch (const SQLite::Exception &error)
    {
        refuse(path, std::string("cannot be made: ") + error.what());
    }
    return open(path);
}
}  // namespace narrows
