// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "CampaignFolder.h"
#include "benchmark/Canary.h"
#include "benchmark/RunOnce.h"

namespace narrows
{
namespace
{
TEST(Canary, StandsFirstLastAndBetween)
{
    const std::optional<std::size_t> canary;
    using Turns = std::vector<std::optional<std::size_t>>;
    EXPECT_EQ(withCanaries(5, 2), (Turns{canary, 0, 1, canary, 2, 3, canary, 4, canary}));
    EXPECT_EQ(withCanaries(2, 2), (Turns{canary, 0, 1, canary}));
    EXPECT_EQ(withCanaries(2, 0), (Turns{0, 1}));
    EXPECT_EQ(withCanaries(0, 2), Turns{});
}

TEST(Canary, AlwaysDoesTheSame)
{
    const Record first = runOnce(canaryRun()), second = runOnce(canaryRun());
    EXPECT_EQ(first.outcome, Outcome::Solved);
    EXPECT_EQ(first.stateChecks, second.stateChecks);
    EXPECT_EQ(first.evaluations, second.evaluations);
    EXPECT_GT(first.stateChecks.value(), 100);
}

TEST_F(CampaignFolder, CanariesAreNoRunsOfTheCampaign)
{
    experiment_.canary = 16;
    const CampaignResult result = run("canary.db");
    EXPECT_EQ(result.done, 40u);
    SQLite::Database database(folder_ + "/canary.db");
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM runs").getInt(), 40);
    EXPECT_EQ(database
                  .execAndGet("SELECT count(*) FROM canaries WHERE outcome = 'solved' AND cpu_time > 0 AND "
                              "environmentid = 1")
                  .getInt(),
              4);
    EXPECT_EQ(database.execAndGet("SELECT count(DISTINCT state_checks) FROM canaries").getInt(), 1);
    // Nothing left to do is nothing to watch.
    run("canary.db", true);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM canaries").getInt(), 4);
}

TEST_F(CampaignFolder, MergedShardsKeepTheirCanaries)
{
    experiment_.canary = 100;
    run("1.db", false, {}, {1, 2});
    run("2.db", false, {}, {2, 2});
    ResultStore::merge(folder_ + "/all.db", {folder_ + "/1.db", folder_ + "/2.db"});
    SQLite::Database database(folder_ + "/all.db");
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM canaries").getInt(), 4);
    EXPECT_EQ(database.execAndGet("SELECT group_concat(DISTINCT environmentid) FROM canaries").getString(), "1,2");
}
}  // namespace
}  // namespace narrows
