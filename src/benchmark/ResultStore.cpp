// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/ResultStore.h"

#include <filesystem>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <nlohmann/json.hpp>

#include "benchmark/ResultFile.h"
#include "benchmark/Sha256.h"

namespace narrows
{
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
        makeTables(*store.database_);
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
