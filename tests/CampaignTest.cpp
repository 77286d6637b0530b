// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "CampaignFolder.h"

namespace narrows
{
namespace
{
TEST_F(CampaignFolder, DoesEveryPlannedRunOnce)
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

TEST_F(CampaignFolder, SameSeedSameRows)
{
    run("a.db");
    run("b.db");
    EXPECT_EQ(rows("a.db"), rows("b.db"));
}

TEST_F(CampaignFolder, ExistingDatabaseNeedsResume)
{
    run("a.db");
    const std::vector<std::string> before = rows("a.db");
    EXPECT_THROW(run("a.db"), InputError);
    EXPECT_TRUE(run("none.db", true).complete());  // nothing to go on with: begin
    EXPECT_EQ(run("a.db", true).done, 0u);
    EXPECT_EQ(rows("a.db"), before);
}

TEST_F(CampaignFolder, StopsWhenAskedAndGoesOn)
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

TEST_F(CampaignFolder, KilledAtAnyMomentItEndsAsIfNothingHadHappened)
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
