// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "benchmark/Metrics.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
class ResultStoreFile : public testing::Test
{
protected:
    ResultStoreFile()
    {
        std::filesystem::create_directories(folder_);
        experiment_ = read("[benchmark]\nrun_count = 3\n[planner]\nrrtconnect =\nbiest =\n");
        specs_ = expand(experiment_);
    }
    ~ResultStoreFile() override { std::filesystem::remove_all(folder_); }

    Experiment read(const std::string &settings) const
    {
        const std::string file = folder_ + "/test.cfg";
        std::ofstream(file) << "[problem]\nname = test\nscenario = " << NARROWS_SOURCE_DIR
                            << "/experiments/scenarios/gap_small.yaml\n"
                            << settings;
        return readExperiment(file);
    }

    ResultStore create() const
    {
        ResultStore store = ResultStore::create(path_, experiment_, "isolated");
        store.beginSession(captureEnvironment(1));
        return store;
    }

    std::vector<std::string> columns(const std::string &table) const
    {
        SQLite::Database database(path_);
        SQLite::Statement query(database, "SELECT name FROM pragma_table_info(?)");
        query.bind(1, table);
        std::vector<std::string> names;
        while (query.executeStep())
            names.push_back(query.getColumn(0).getString());
        return names;
    }

    std::string scalar(const std::string &sql) const
    {
        SQLite::Database database(path_);
        const SQLite::Column column = database.execAndGet(sql);
        return column.isNull() ? "NULL" : column.getString();
    }

    void execute(const std::string &sql) const
    {
        SQLite::Database database(path_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec(sql);
    }

    /// What open() complains about; empty if it does not.
    std::string complaint() const
    {
        try
        {
            ResultStore::open(path_);
            return "";
        }
        catch (const InputError &error)
        {
            EXPECT_EQ(error.faults().front().file, path_);
            return error.faults().front().reason;
        }
    }

    std::string folder_ = testing::TempDir() + "resultstore" + std::to_string(getpid());
    std::string path_ = folder_ + "/test.db";
    Experiment experiment_;
    std::vector<RunSpec> specs_;
};

Record solved(double length, int waypoints = 2)
{
    Record record;
    record.outcome = Outcome::Solved;
    record.verified = true;
    record.length = length;
    record.clearance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < waypoints; ++i)
        record.path.push_back(Eigen::Vector3d(0.1 * i, 0.2, 1.0 / 3.0));
    return record;
}

TEST_F(ResultStoreFile, HasTheTablesAndColumnOrderOfOmpl)
{
    create();
    EXPECT_THAT(columns("experiments"),
                testing::ElementsAre("id", "name", "totaltime", "timelimit", "memorylimit", "runcount", "version",
                                     "hostname", "cpuinfo", "date", "seed", "setup", "scenario", "checker", "motion"));
    EXPECT_THAT(columns("plannerConfigs"), testing::ElementsAre("id", "name", "settings"));
    EXPECT_THAT(columns("enums"), testing::ElementsAre("name", "value", "description"));
    EXPECT_THAT(columns("progress"), testing::ElementsAre("runid", "time"));
    std::vector<std::string> runs = columns("runs");
    ASSERT_EQ(runs.size(), 3 + metrics().size() + 1);
    runs.resize(7);
    EXPECT_THAT(runs, testing::ElementsAre("id", "experimentid", "plannerid", "time", "memory", "status", "solved"));
    EXPECT_EQ(scalar("PRAGMA user_version"), "1");
    EXPECT_EQ(scalar("PRAGMA journal_mode"), "wal");
    EXPECT_EQ(scalar("SELECT description FROM enums WHERE name = 'status' AND value = 6"), "Exact solution");
}

TEST_F(ResultStoreFile, SaysWhatPlannerArenaAsks)
{
    create();
    EXPECT_EQ(scalar("SELECT version FROM experiments"), omplVersion());
#if OMPL_VERSION_VALUE == 1005002
    EXPECT_EQ(omplVersion(), "OMPL 1.5.2");
#endif
    EXPECT_EQ(scalar("SELECT name FROM experiments"), "gap-small_analytic");
    EXPECT_EQ(scalar("SELECT runcount FROM experiments"), "3");
    EXPECT_EQ(scalar("SELECT count(*) FROM bestPlannerConfigs"), "0");
    EXPECT_EQ(scalar("SELECT scenario FROM instances"), experiment_.scenarios.front()->text);
    EXPECT_NE(scalar("SELECT compiler FROM environments"), "NULL");
}

TEST_F(ResultStoreFile, KeepsWhatWasNotMeasuredApartFromZero)
{
    {
        ResultStore store = create();
        Record record = solved(0.0);
        record.stateChecks = 0;
        record.stopDuration = 7.5;
        record.measures = {{"spheres", 146.0}};
        store.add(specs_[0], record, SavePaths::None);
    }
    EXPECT_EQ(scalar("SELECT state_checks FROM runs"), "0");
    EXPECT_EQ(scalar("SELECT motion_checks FROM runs"), "NULL");
    EXPECT_EQ(scalar("SELECT stop_duration FROM runs"), "7.5");
    EXPECT_EQ(scalar("SELECT duration FROM runs"), "NULL");
    EXPECT_EQ(scalar("SELECT solution_clearance FROM runs"), "NULL");  // infinite
    EXPECT_EQ(scalar("SELECT solved FROM runs"), "1");
    EXPECT_EQ(scalar("SELECT seed FROM runs"), std::to_string(specs_[0].seed));
    EXPECT_EQ(scalar("SELECT json_extract(measures, '$.spheres') FROM runs"), "146.0");
    EXPECT_EQ(scalar("SELECT environmentid FROM runs"), "1");
}

TEST_F(ResultStoreFile, OnlyVerifiedExactPathsAreSolved)
{
    {
        ResultStore store = create();
        Record refused = solved(1.0);
        refused.outcome = Outcome::Unverified;
        refused.verified = false;
        store.add(specs_[0], refused, SavePaths::All);
        Record approximate = solved(1.0);
        approximate.outcome = Outcome::Approximate;
        approximate.verified.reset();
        store.add(specs_[1], approximate, SavePaths::All);
    }
    EXPECT_EQ(scalar("SELECT sum(solved) FROM runs"), "0");
    EXPECT_EQ(scalar("SELECT group_concat(coalesce(correct_solution, 'NULL')) FROM runs"), "0,NULL");
    EXPECT_EQ(scalar("SELECT sum(approximate_solution) FROM runs"), "1");
}

TEST_F(ResultStoreFile, TheDoctorFindsAPathWhereThereIsNoWay)
{
    create().add(specs_[0], solved(1.0), SavePaths::All);
    EXPECT_THAT(ResultStore::open(path_).examine().faults, testing::IsEmpty());
    SQLite::Database(path_, SQLite::OPEN_READWRITE)
        .exec("UPDATE instances SET scenario = scenario || char(10) || 'infeasible: {first_joint: [0, 1]}'");
    EXPECT_THAT(ResultStore::open(path_).examine().faults,
                testing::Contains("run 1 counts as solved, though its scenario is proven to have no way"));
}

TEST_F(ResultStoreFile, TakesEveryRunOnce)
{
    ResultStore store = create();
    store.add(specs_[0], solved(1.0), SavePaths::All);
    EXPECT_THROW(store.add(specs_[0], solved(2.0), SavePaths::All), std::runtime_error);
    RunSpec stranger = specs_[1];
    stranger.instance = "elsewhere";
    EXPECT_THROW(store.add(stranger, solved(2.0), SavePaths::All), std::runtime_error);
    EXPECT_EQ(store.runs().size(), 1u);
}

TEST_F(ResultStoreFile, KnowsWhatIsMissing)
{
    {
        ResultStore store = create();
        EXPECT_EQ(store.missing(specs_).size(), 6u);
        store.add(specs_[4], solved(1.0), SavePaths::None);
        store.add(specs_[1], Record(), SavePaths::None);
    }
    const ResultStore store = ResultStore::resume(path_, experiment_, "isolated");
    const std::vector<RunSpec> missing = store.missing(specs_);
    ASSERT_EQ(missing.size(), 4u);
    EXPECT_EQ(missing[0].seed, specs_[0].seed);
    EXPECT_EQ(missing[1].seed, specs_[2].seed);
    EXPECT_EQ(missing[2].seed, specs_[3].seed);
    EXPECT_EQ(missing[3].seed, specs_[5].seed);
}

TEST_F(ResultStoreFile, RefusesToResumeAnotherCampaign)
{
    create();
    EXPECT_NO_THROW(ResultStore::resume(path_, experiment_, "isolated"));
    EXPECT_THROW(ResultStore::resume(path_, experiment_, "ompl"), InputError);
    Experiment otherSeed = experiment_;
    otherSeed.text += "\n";
    EXPECT_THROW(ResultStore::resume(path_, otherSeed, "isolated"), InputError);
    Experiment otherScenario = experiment_;
    auto changed = std::make_shared<Scenario>(*experiment_.scenarios.front());
    changed->text += "\n";
    otherScenario.scenarios = {changed};
    EXPECT_THROW(ResultStore::resume(path_, otherScenario, "isolated"), InputError);
}

TEST_F(ResultStoreFile, OverwritesNothing)
{
    create();
    EXPECT_THROW(ResultStore::create(path_, experiment_, "isolated"), InputError);
    EXPECT_EQ(complaint(), "");
}

TEST_F(ResultStoreFile, RefusesWhatIsNotItsOwn)
{
    EXPECT_THAT(complaint(), testing::HasSubstr("there is no such database"));
    std::ofstream(path_) << std::string(5000, 'x');
    EXPECT_THAT(complaint(), testing::HasSubstr("cannot be read as a database"));
    std::filesystem::remove(path_);
    execute("CREATE TABLE runs (id INTEGER)");
    EXPECT_THAT(complaint(), testing::HasSubstr("none that `narrows bench` made"));
}

TEST_F(ResultStoreFile, RefusesANewerSchema)
{
    create();
    execute("PRAGMA user_version = 2");
    EXPECT_THAT(complaint(), testing::HasSubstr("schema version 2; this program reads version 1"));
}

TEST_F(ResultStoreFile, AddsTheMetricsThatAnOlderProgramDidNotKnow)
{
    create();
    execute("ALTER TABLE runs DROP COLUMN closure");
    {
        ResultStore store = ResultStore::resume(path_, experiment_, "isolated");
        store.beginSession(captureEnvironment(1));
        Record record = solved(1.0, 200);
        record.closure = 0.25;
        store.add(specs_.front(), record, SavePaths::None);
    }
    EXPECT_EQ(columns("runs").back(), "closure");
    EXPECT_EQ(scalar("SELECT closure FROM runs"), "0.25");
    EXPECT_EQ(scalar("SELECT outcome FROM runs"), "solved");
}

TEST_F(ResultStoreFile, RefusesADamagedFile)
{
    {
        ResultStore store = create();
        for (const RunSpec &spec : specs_)
            store.add(spec, solved(1.0, 200), SavePaths::All);
    }
    ASSERT_EQ(complaint(), "");
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path_));
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    for (std::streamoff page = 4096; page < size; page += 4096)  // the first holds the header, which is left alone
    {
        file.seekp(page);
        file << std::string(64, '\xff');
    }
    file.close();
    EXPECT_NE(complaint(), "");
}

TEST_F(ResultStoreFile, KeepsTheShortestPathWhateverTheOrder)
{
    for (const std::vector<int> &order : {std::vector<int>{0, 1, 2}, {2, 1, 0}, {1, 0, 2}})
    {
        std::filesystem::remove(path_);
        ResultStore store = create();
        const double lengths[] = {3.0, 2.0, 2.0};
        for (const int run : order)
            for (const RunSpec &spec : specs_)
                if (spec.run == run && spec.label == "biest")
                    store.add(spec, solved(lengths[run]), SavePaths::Shortest);
        std::vector<int> kept;
        store.eachPath([&](const PathRow &row) { kept.push_back(row.run); });
        EXPECT_THAT(kept, testing::ElementsAre(1));
    }
}

TEST_F(ResultStoreFile, GivesPathsBackToTheLastBit)
{
    ResultStore store = create();
    Record record = solved(1.0);
    record.path[1][0] = std::nan("");
    store.add(specs_[0], record, SavePaths::All);
    int visits = 0;
    store.eachPath(
        [&](const PathRow &row)
        {
            ++visits;
            ASSERT_EQ(row.path.size(), 2u);
            EXPECT_EQ(row.path[0], record.path[0]);
            EXPECT_TRUE(std::isnan(row.path[1][0]));
            EXPECT_EQ(row.scenarioText, experiment_.scenarios.front()->text);
        });
    EXPECT_EQ(visits, 1);
}
}  // namespace
}  // namespace narrows
