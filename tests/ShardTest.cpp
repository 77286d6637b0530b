// SPDX-License-Identifier: BSD-3-Clause
// Campaigns in parts: shards, their merging, and what can be asked of a database afterwards.
#include <set>

#include <gmock/gmock.h>

#include "CampaignFolder.h"
#include "benchmark/Replay.h"

namespace narrows
{
namespace
{
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Shards : public CampaignFolder
{
protected:
    std::string path(const std::string &name) const { return folder_ + "/" + name; }

    void runShards(int count) const
    {
        for (int i = 1; i <= count; ++i)
            run("part" + std::to_string(i) + ".db", false, {}, {i, count});
    }

    void execute(const std::string &name, const std::string &sql) const
    {
        SQLite::Database(path(name), SQLite::OPEN_READWRITE).exec(sql);
    }

    /// What merging complains about; empty if it does not.
    std::string complaint(const std::vector<std::string> &parts, bool unlike = false) const
    {
        std::vector<std::string> paths;
        for (const std::string &part : parts)
            paths.push_back(path(part));
        try
        {
            ResultStore::merge(path("merged.db"), paths, unlike);
            return "";
        }
        catch (const InputError &error)
        {
            return error.faults().front().reason;
        }
    }
};

TEST(Shard, IsReadFromText)
{
    EXPECT_EQ(shardFromText("2/8").index, 2);
    EXPECT_EQ(shardFromText("2/8").count, 8);
    for (const char *text : {"", "1", "0/2", "3/2", "1/0", "a/b", "1/2/3", " 1/2", "1/2 ", "-1/2", "1.5/2"})
        EXPECT_THROW(shardFromText(text), std::invalid_argument) << text;
}

TEST_F(Shards, EveryRunIsInExactlyOneAndBlocksStayTogether)
{
    const std::vector<RunSpec> all = expand(experiment_);
    std::set<std::uint32_t> seeds;
    for (int i = 1; i <= 3; ++i)
    {
        std::map<std::pair<std::string, int>, int> blocks;
        for (const RunSpec &spec : runsOf({i, 3}, all))
        {
            EXPECT_TRUE(seeds.insert(spec.seed).second);
            ++blocks[{spec.instance, spec.run}];
        }
        for (const auto &[block, planners] : blocks)
            EXPECT_EQ(planners, 4) << block.first << " " << block.second;
        EXPECT_GE(blocks.size(), 3u);  // ten blocks in three shards
        EXPECT_LE(blocks.size(), 4u);
    }
    EXPECT_EQ(seeds.size(), all.size());
    EXPECT_TRUE(runsOf({12, 12}, all).empty());  // more shards than blocks
}

TEST_F(Shards, MergedTheyAreTheCampaign)
{
    run("whole.db");
    runShards(3);
    EXPECT_EQ(complaint({"part2.db", "part1.db", "part3.db"}), "");
    EXPECT_EQ(rows("merged.db"), rows("whole.db"));
    EXPECT_THAT(ResultStore::open(path("merged.db")).examine().faults, IsEmpty());
    // A merged database is a campaign's: nothing is missing.
    EXPECT_EQ(run("merged.db", true).done, 0u);
    // The parts are as they were, and nothing else is left beside them.
    EXPECT_EQ(run("part1.db", true, {}, {1, 3}).done, 0u);
    for (const auto &file : std::filesystem::directory_iterator(folder_))
        EXPECT_THAT(file.path().string(), Not(HasSubstr("merging")));
}

TEST_F(Shards, OneThatWasKilledIsFinishedByResuming)
{
    run("whole.db");
    run("part1.db", false, {}, {1, 2});
    int polls = 0;
    run("part2.db", false, [&] { return ++polls > 10; }, {2, 2});
    EXPECT_TRUE(run("part2.db", true, {}, {2, 2}).complete());
    EXPECT_EQ(complaint({"part1.db", "part2.db"}), "");
    EXPECT_EQ(rows("merged.db"), rows("whole.db"));
}

TEST_F(Shards, AreNotMergedTwiceNorWithAnotherCampaign)
{
    runShards(2);
    EXPECT_THAT(complaint({"part1.db", "part1.db"}), HasSubstr("another part holds too"));
    experiment_.text += "; another\n";
    run("other.db", false, {}, {2, 2});
    EXPECT_THAT(complaint({"part1.db", "other.db"}), HasSubstr("another campaign"));
    EXPECT_THAT(complaint({"part1.db", "none.db"}), HasSubstr("no such database"));
    EXPECT_FALSE(std::filesystem::exists(path("merged.db")));  // failures leave nothing behind
    EXPECT_EQ(complaint({"part1.db", "part2.db"}), "");
    EXPECT_THAT(complaint({"part1.db", "part2.db"}), HasSubstr("exists already"));
    EXPECT_THROW(ResultStore::merge(path("empty.db"), {}), std::invalid_argument);
}

TEST_F(Shards, OfUnlikeMachinesAreMergedOnlyWhenAsked)
{
    runShards(2);
    execute("part2.db", "UPDATE environments SET load_average = 'other', jobs = '7'");
    EXPECT_EQ(complaint({"part1.db", "part2.db"}), "");  // says nothing against comparing
    std::filesystem::remove(path("merged.db"));
    execute("part2.db", "UPDATE environments SET cpu = 'another'");
    EXPECT_THAT(complaint({"part1.db", "part2.db"}), HasSubstr("unlike environment (cpu: "));
    EXPECT_FALSE(std::filesystem::exists(path("merged.db")));
    EXPECT_EQ(complaint({"part1.db", "part2.db"}, true), "");
    EXPECT_THAT(ResultStore::open(path("merged.db")).examine().notes, testing::Contains(HasSubstr("differ in cpu")));
}

TEST_F(Shards, TheDoctorFindsWhatIsNotAsItShouldBe)
{
    run("a.db", false, {}, {1, 2});
    const Diagnosis healthy = ResultStore::open(path("a.db")).examine();
    EXPECT_THAT(healthy.faults, IsEmpty());
    EXPECT_THAT(healthy.notes, testing::Contains(HasSubstr("of 5 runs")));  // half of the campaign
    execute("a.db", "UPDATE instances SET scenario = scenario || ' ' WHERE experimentid = 1");
    execute("a.db", "UPDATE runs SET verified = 0 WHERE id = 2");
    execute("a.db", "UPDATE runs SET outcome = 'timeout' WHERE id = 3");
    execute("a.db", "PRAGMA foreign_keys = OFF; DELETE FROM plannerConfigs WHERE name = 'biest'");
    EXPECT_THAT(ResultStore::open(path("a.db")).examine().faults,
                ElementsAre("rows of runs refer to rows that are not there", HasSubstr("SHA-256"),
                            HasSubstr("run 2 counts as solved"), HasSubstr("run 3 contradicts itself")));
}

TEST_F(Shards, AnyRunCanBeDoneOnceMore)
{
    run("a.db");
    const ResultStore store = ResultStore::open(path("a.db"));
    for (const std::int64_t id : {1, 17, 40})
    {
        const ReplayResult result = replay(store, id);
        EXPECT_THAT(result.deviations, IsEmpty()) << id;
        EXPECT_EQ(result.record.outcome, Outcome::Solved);
    }
    EXPECT_THROW(replay(store, 41), std::invalid_argument);
    execute("a.db", "UPDATE runs SET state_checks = -1, cpu_time = -1 WHERE id = 5");
    const ReplayResult changed = replay(store, 5);
    ASSERT_EQ(changed.deviations.size(), 1u);
    EXPECT_EQ(changed.deviations[0].column, "state_checks");
    EXPECT_EQ(changed.deviations[0].stored, "-1");
}

/// Ended by a count, not by the clock, even runs that solve nothing come out the same.
TEST_F(Shards, RunsWithinABudgetRepeatThemselves)
{
    std::ofstream(folder_ + "/budget.cfg") << "[problem]\nname = budget\nscenario = " << NARROWS_SOURCE_DIR
                                           << "/experiments/scenarios/hppm_case3.yaml\n[benchmark]\nrun_count = 2\n"
                                              "time_limit = 100\nevaluation_limit = 1500\nstate_check_limit = 150\n"
                                              "[planner]\nrrt =\nkpiece1 =\nhppm =\nhppm.recipe = none\n";
    experiment_ = readExperiment(folder_ + "/budget.cfg");
    run("a.db");
    run("b.db");
    EXPECT_EQ(rows("a.db"), rows("b.db"));
    const ResultStore store = ResultStore::open(path("a.db"));
    int limited = 0;
    for (const RunRow &row : store.runs())
        limited += row.reason == "state_check_limit" || row.reason == "evaluation_limit" ? 1 : 0;
    EXPECT_GE(limited, 4);
    for (std::int64_t id = 1; id <= 6; ++id)
        EXPECT_THAT(replay(store, id).deviations, IsEmpty()) << id;
}

TEST_F(Shards, RunsWithRecipesAndListsCanBeDoneOnceMore)
{
    std::ofstream(folder_ + "/recipe.cfg") << "[problem]\nname = recipe\nscenario = " << NARROWS_SOURCE_DIR
                                           << "/experiments/scenarios/hppm_case1.yaml\n[benchmark]\nrun_count = 1\n"
                                              "[planner]\nhppm =\nhppm.search = paper\nhppm.rows = 1, 3, 2; 1, -1, 4; "
                                              "1, 1, -2\nhppm =\nhppm.recipe = none\nhppm.name = alone\n";
    experiment_ = readExperiment(folder_ + "/recipe.cfg");
    run("a.db");
    const ResultStore store = ResultStore::open(path("a.db"));
    for (const std::int64_t id : {1, 2})
        EXPECT_THAT(replay(store, id).deviations, IsEmpty()) << id;
}
}  // namespace
}  // namespace narrows
