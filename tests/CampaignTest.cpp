// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "benchmark/Campaign.h"
#include "benchmark/Metrics.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
namespace
{
class Campaign : public testing::Test
{
protected:
    Campaign()
    {
        std::filesystem::create_directories(folder_);
        const std::string file = folder_ + "/test.cfg";
        std::ofstream(file) << "[problem]\nname = test\nscenario = " << NARROWS_SOURCE_DIR
                            << "/experiments/scenarios/gap_small.yaml, " << NARROWS_SOURCE_DIR
                            << "/experiments/scenarios/hppm_case1.yaml\n"
                               "[benchmark]\nrun_count = 5\nwarm_up = 0\nsimplify = 1\nsave_paths = shortest\n"
                               "time_limit = 20\njobs = 2\n"
                               "[planner]\nrrtconnect =\nbiest =\nkpiece1 =\nrrtconnect =\nrrtconnect.range = 0.5\n";
        experiment_ = readExperiment(file);
    }
    ~Campaign() override { std::filesystem::remove_all(folder_); }

    CampaignResult run(const std::string &database, bool resume = false, std::function<bool()> stop = {}) const
    {
        CampaignOptions options;
        options.database = folder_ + "/" + database;
        options.resume = resume;
        options.stop = std::move(stop);
        return runCampaign(experiment_, options);
    }

    /// Every run's repeatable columns and stored path as one text each, in the order of the plan, not of the rows.
    std::vector<std::string> rows(const std::string &name) const
    {
        const std::set<std::string> measured{"time", "cpu_time", "simplification_time", "memory", "peak_memory_kb"};
        std::string columns;
        for (const Metric &metric : metrics())
            if (measured.count(metric.name) == 0)
                columns += ", runs." + metric.name;
        SQLite::Database database(folder_ + "/" + name);
        SQLite::Statement query(database, "SELECT experiments.name, plannerConfigs.name, settings" + columns +
                                              ", angles FROM runs JOIN experiments ON experiments.id = experimentid "
                                              "JOIN plannerConfigs ON plannerConfigs.id = plannerid "
                                              "LEFT JOIN paths ON runid = runs.id ORDER BY 1, 2, 3, run");
        std::vector<std::string> texts;
        while (query.executeStep())
        {
            std::ostringstream text;
            for (int i = 0; i < query.getColumnCount(); ++i)
                text << (query.getColumn(i).isNull() ? "NULL" : query.getColumn(i).getString()) << " | ";
            texts.push_back(text.str());
        }
        return texts;
    }

    std::string folder_ = testing::TempDir() + "campaign" + std::to_string(getpid());
    Experiment experiment_;
};

TEST_F(Campaign, DoesEveryPlannedRunOnce)
{
    const CampaignResult result = run("a.db");
    EXPECT_EQ(result.planned, 40u);
    EXPECT_EQ(result.done, 40u);
    EXPECT_TRUE(result.complete());
    const ResultStore store = ResultStore::open(folder_ + "/a.db");
    EXPECT_TRUE(store.missing(expand(experiment_)).empty());
    for (const RunRow &row : store.runs())
        EXPECT_EQ(row.outcome, Outcome::Solved)
            << row.instance << " " << row.label << " " << row.run << ": " << row.reason;
    int paths = 0;
    store.eachPath([&](const PathRow &) { ++paths; });
    EXPECT_EQ(paths, 8);
}

TEST_F(Campaign, SameSeedSameRows)
{
    run("a.db");
    run("b.db");
    EXPECT_EQ(rows("a.db"), rows("b.db"));
}

TEST_F(Campaign, ExistingDatabaseNeedsResume)
{
    run("a.db");
    const std::vector<std::string> before = rows("a.db");
    EXPECT_THROW(run("a.db"), InputError);
    EXPECT_TRUE(run("none.db", true).complete());  // nothing to go on with: begin
    EXPECT_EQ(run("a.db", true).done, 0u);
    EXPECT_EQ(rows("a.db"), before);
}

TEST_F(Campaign, StopsWhenAskedAndGoesOn)
{
    run("whole.db");
    int polls = 0;
    const CampaignResult first = run("a.db", false, [&] { return ++polls > 30; });
    EXPECT_LT(first.done, 40u);
    const CampaignResult second = run("a.db", true);
    EXPECT_EQ(second.existing, first.done);
    EXPECT_TRUE(second.complete());
    EXPECT_EQ(rows("a.db"), rows("whole.db"));
}

TEST_F(Campaign, KilledAtAnyMomentItEndsAsIfNothingHadHappened)
{
    const auto begin = std::chrono::steady_clock::now();
    run("whole.db");
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
    const std::vector<std::string> expected = rows("whole.db");

    constexpr unsigned seed = 4;
    std::mt19937 generator(seed);
    for (int round = 0; round < 6; ++round)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
        const std::string name = "killed" + std::to_string(round) + ".db";
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0)
        {
            run(name);
            _exit(0);
        }
        std::this_thread::sleep_for(whole * (static_cast<double>(generator() % 1000) / 1000.0));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        // Killed before its first transaction, it leaves no campaign: then there is nothing to go on with.
        try
        {
            ResultStore::open(folder_ + "/" + name);
        }
        catch (const InputError &)
        {
            for (const char *suffix : {"", "-wal", "-shm", "-journal"})
                std::filesystem::remove(folder_ + "/" + name + suffix);
            run(name);
        }
        run(name, true);
        EXPECT_EQ(rows(name), expected);
    }
}
}  // namespace
}  // namespace narrows
