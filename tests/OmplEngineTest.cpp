// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/OmplEngine.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>
#include <ompl/config.h>

#include "FaultPlanners.h"
#include "RunSpecs.h"

namespace narrows
{
namespace
{
namespace fs = std::filesystem;

/// A fresh folder that goes with the test.
class Folder
{
public:
    Folder()
    {
        std::string name = (fs::temp_directory_path() / "narrows-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no folder");
        path_ = name;
    }
    ~Folder() { fs::remove_all(path_); }

    std::string operator/(const std::string &name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

std::vector<RunSpec> campaign()
{
    faultPlanners();
    std::vector<RunSpec> specs;
    for (const char *planner : {"rrtconnect", "bkpiece1", "fault_logic_error", "fault_collides"})
        for (int run = 0; run < 3; ++run)
        {
            RunSpec spec = smallRun(planner, static_cast<std::uint32_t>(100 + run));
            spec.run = run;
            spec.simplify = true;
            specs.push_back(spec);
        }
    for (int run = 0; run < 3; ++run)
    {
        RunSpec spec = smallRun("rrtconnect", 9);
        spec.label = "rrtconnect-relative";
        spec.problem.space = "relative";
        spec.run = run;
        specs.push_back(spec);
    }
    return specs;
}

std::map<std::size_t, Record> run(const std::vector<RunSpec> &specs, const std::string &prefix,
                                  std::vector<std::string> &logs)
{
    std::map<std::size_t, Record> records;
    logs = runOmplBenchmark(specs, prefix,
                            [&records](std::size_t index, const Record &record)
                            { EXPECT_TRUE(records.emplace(index, record).second) << index; });
    return records;
}

std::string firstLine(const std::string &path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

TEST(OmplEngine, EveryRunLeavesARecordWithOurVerdict)
{
    const std::vector<RunSpec> specs = campaign();
    const Folder folder;
    std::vector<std::string> logs;
    const std::map<std::size_t, Record> records = run(specs, folder / "", logs);
    ASSERT_EQ(records.size(), specs.size());
    for (const auto &[index, record] : records)
    {
        const std::string &planner = specs[index].planner;
        const Outcome expected = planner == "fault_logic_error" ? Outcome::Crash
                                 : planner == "fault_collides"  ? Outcome::Unverified
                                                                : Outcome::Solved;
        EXPECT_EQ(toString(record.outcome), toString(expected)) << planner << ": " << record.reason;
        EXPECT_TRUE(record.time && record.cpuTime && record.stateChecks);
        EXPECT_TRUE(record.measures.count("process_seed"));
        EXPECT_FALSE(record.peakMemoryKb);
        if (record.outcome == Outcome::Solved && specs[index].simplify)
        {
            EXPECT_EQ(record.simplifiedVerified, true);
            EXPECT_LE(record.simplifiedLength.value(), record.length.value() * (1.0 + 1e-9));
        }
    }
    EXPECT_EQ(logs, (std::vector<std::string>{folder / "gap-small.log", folder / "gap-small-2.log"}));
    for (const std::string &log : logs)
        EXPECT_EQ(firstLine(log).rfind("OMPL version " + std::to_string(OMPL_MAJOR_VERSION) + ".", 0), 0u);
}

TEST(OmplEngine, DebiansStatisticsProgramReadsTheLogs)
{
    const std::string program = "/usr/bin/ompl_benchmark_statistics";
    ASSERT_TRUE(fs::exists(program)) << "is not installed: package ompl-demos, see tools/debian-packages.txt";
    const Folder folder;
    std::vector<std::string> logs;
    run(campaign(), folder / "", logs);
    const std::string path = folder / "runs.db";
    std::string command = "/usr/bin/python3 " + program + " -d " + path;
    for (const std::string &log : logs)
        command += " " + log;
    ASSERT_EQ(std::system((command + " >" + folder / "output 2>&1").c_str()), 0) << command;

    SQLite::Database db(path);
    EXPECT_EQ(db.execAndGet("SELECT count(*) FROM runs").getInt(), 15);
    EXPECT_EQ(db.execAndGet("SELECT sum(verified) FROM runs").getInt(), 9);
    EXPECT_EQ(db.execAndGet("SELECT sum(solved) FROM runs").getInt(), 12);  // OMPL believes the path through the wall
    EXPECT_EQ(db.execAndGet("SELECT count(cpu_time) FROM runs").getInt(), 15);
    EXPECT_EQ(db.execAndGet("SELECT count(state_checks) FROM runs").getInt(), 15);
    EXPECT_EQ(db.execAndGet("SELECT count(*) FROM experiments WHERE name = 'gap-small'").getInt(), 2);
    const std::string version = "OMPL " + std::to_string(OMPL_MAJOR_VERSION) + "." +
                                std::to_string(OMPL_MINOR_VERSION) + "." + std::to_string(OMPL_PATCH_VERSION);
    EXPECT_EQ(db.execAndGet("SELECT version FROM experiments").getString(), version);
    std::vector<std::string> columns;
    SQLite::Statement info(db, "PRAGMA table_info(experiments)");
    while (info.executeStep())
        columns.push_back(info.getColumn(1).getString());
    ASSERT_EQ(columns.size(), 15u);
    EXPECT_EQ(std::vector<std::string>(columns.begin() + 12, columns.end()),
              (std::vector<std::string>{"checker", "motion", "space"}));
}

TEST(OmplEngine, ExceptionsOfTheCallerArrive)
{
    const Folder folder;
    EXPECT_THROW(runOmplBenchmark({smallRun("rrtconnect")}, folder / "",
                                  [](std::size_t, const Record &) { throw std::logic_error("disk full"); }),
                 std::logic_error);
}

TEST(OmplEngine, ALogThatCannotBeWrittenIsAnError)
{
    std::vector<std::string> logs;
    EXPECT_THROW(run({smallRun("rrtconnect")}, "/no/such/folder/", logs), std::runtime_error);
}
}  // namespace
}  // namespace narrows
