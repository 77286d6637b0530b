// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
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

/// Campaigns in processes of their own, which are killed.
class KilledCampaign : public CampaignFolder
{
protected:
    enum Target
    {
        Runner,
        ARun,
        Group  ///< the runner's process group
    };

    pid_t start(const std::string &name) const
    {
        const pid_t runner = fork();
        if (runner == 0)
        {
            setpgid(0, 0);
            run(name, true);
            _exit(0);
        }
        setpgid(runner, runner);
        return runner;
    }

    /// Its runs, as they are at this moment.
    static std::vector<pid_t> runsOf(pid_t runner)
    {
        std::vector<pid_t> runs;
        const std::string number = std::to_string(runner);
        std::ifstream list("/proc/" + number + "/task/" + number + "/children");
        for (pid_t run = 0; list >> run;)
            runs.push_back(run);
        return runs;
    }

    static void strike(pid_t runner, Target target)
    {
        if (target == ARun)
        {
            const std::vector<pid_t> runs = runsOf(runner);
            if (!runs.empty())
                kill(runs.front(), SIGKILL);
        }
        else
            kill(target == Group ? -runner : runner, SIGKILL);
    }

    /// Kills without end do not happen: NARROWS_KILLS of them, or a few.
    static int killsToDo()
    {
        const char *const text = std::getenv("NARROWS_KILLS");
        return text != nullptr ? std::atoi(text) : 8;
    }
};

TEST_F(KilledCampaign, EndsAsIfNothingHadHappened)
{
    const auto begin = std::chrono::steady_clock::now();
    run("whole.db");
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begin;
    const std::vector<std::string> expected = rows("whole.db");

    constexpr unsigned seed = 4;
    std::mt19937 generator(seed);
    int campaigns = 0;
    for (int kills = 0; kills < killsToDo(); ++campaigns)
    {
        const std::string name = "killed" + std::to_string(campaigns) + ".db";
        for (bool complete = false; !complete;)
        {
            const pid_t runner = start(name);
            ASSERT_GT(runner, 0);
            const bool armed = kills < killsToDo();
            if (armed)
            {
                std::this_thread::sleep_for(whole * (static_cast<double>(generator() % 1000) / 1000.0));
                strike(runner, static_cast<Target>(generator() % 3));
                ++kills;
            }
            int status = 0;
            waitpid(runner, &status, 0);
            complete = WIFEXITED(status);
            // Whenever it was killed, what it leaves is sound, or as if it had not begun.
            const std::string database = folder_ + "/" + name;
            if (!complete && std::filesystem::exists(database) && !ResultStore::isBlank(database))
            {
                EXPECT_THAT(ResultStore::open(database).examine().faults, testing::IsEmpty());
            }
        }
        EXPECT_EQ(rows(name), expected) << "seed " << seed << ", campaign " << campaigns;
        EXPECT_TRUE(run(name, true).complete());
        std::filesystem::remove(folder_ + "/" + name);
    }
}

/// The limit on the size of files stands for a full disk.
TEST_F(KilledCampaign, AFullDiskLosesNothing)
{
    run("whole.db");
    const std::vector<std::string> expected = rows("whole.db");
    int refused = 0;
    for (const rlim_t room : {8192, 60000, 100000, 140000, 180000})
    {
        const pid_t runner = fork();
        ASSERT_GE(runner, 0);
        if (runner == 0)
        {
            std::signal(SIGXFSZ, SIG_IGN);
            rlimit limit{};
            getrlimit(RLIMIT_FSIZE, &limit);
            limit.rlim_cur = room;
            setrlimit(RLIMIT_FSIZE, &limit);
            try
            {
                run("full.db", true);
                _exit(0);
            }
            catch (const InputError &error)
            {
                const std::string text = error.what();
                _exit(text.find("full.db") != std::string::npos && text.find("cannot be") != std::string::npos ? 1 : 2);
            }
        }
        int status = 0;
        waitpid(runner, &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_LE(WEXITSTATUS(status), 1);
        refused += WEXITSTATUS(status);
    }
    EXPECT_GE(refused, 2);
    EXPECT_TRUE(run("full.db", true).complete());
    EXPECT_EQ(rows("full.db"), expected);
}

TEST_F(CampaignFolder, AFolderThatCannotBeWrittenIsNamed)
{
    CampaignOptions options;
    options.database = "/proc/narrows/a.db";
    try
    {
        runCampaign(experiment_, options);
        FAIL();
    }
    catch (const InputError &error)
    {
        EXPECT_EQ(error.faults().front().file, options.database);
        EXPECT_THAT(error.faults().front().reason, testing::HasSubstr("cannot be made"));
    }
}
}  // namespace
}  // namespace narrows
