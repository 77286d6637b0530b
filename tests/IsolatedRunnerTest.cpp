// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/IsolatedRunner.h"

#include <csignal>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "FaultPlanners.h"
#include "RunSpecs.h"
#include "benchmark/Cores.h"
#include "benchmark/RunOnce.h"
#include "benchmark/SolveLimit.h"

namespace narrows
{
namespace
{
using Records = std::map<std::size_t, Record>;

/// A pipe that every process started meanwhile holds open: it is at its end when they are all gone.
class Lifeline
{
public:
    Lifeline()
    {
        int ends[2];
        if (pipe(ends) != 0)
            throw std::runtime_error("no pipe");
        read_ = ends[0];
        write_ = ends[1];
    }
    ~Lifeline()
    {
        close(read_);
        if (write_ >= 0)
            close(write_);
    }

    int writeEnd() const { return write_; }

    char readByte() const
    {
        char byte = 0;
        return read(read_, &byte, 1) == 1 ? byte : '\0';
    }

    /// True once nobody but us is left, false if that takes too long.
    bool everybodyIsGone()
    {
        close(write_);
        write_ = -1;
        constexpr int patience = 20000;  // ms; a killed process needs none, a busy machine some
        pollfd descriptor{read_, POLLIN, 0};
        return poll(&descriptor, 1, patience) == 1 && readByte() == '\0';
    }

private:
    int read_ = -1;
    int write_ = -1;
};

/// Does the runs and checks that each leaves one record.
Records runEach(const std::vector<RunSpec> &specs, int jobs)
{
    Records records;
    runAll(specs, jobs,
           [&records](std::size_t index, const Record &record)
           { EXPECT_TRUE(records.emplace(index, record).second) << "two records of run " << index; });
    EXPECT_EQ(records.size(), specs.size());
    return records;
}

RunSpec goodRun(const std::string &planner, std::uint32_t seed)
{
    RunSpec spec = smallRun(planner, seed);
    spec.timeLimit = 30.0;
    spec.simplify = true;
    return spec;
}

RunSpec faultyRun(const Fault &fault)
{
    RunSpec spec = smallRun(fault.planner);
    spec.timeLimit = 1.0;
    spec.memoryLimit = 256.0;
    return spec;
}

/// Good runs by planner and seed, without what may differ.
std::map<std::string, nlohmann::json> goodOnes(const std::vector<RunSpec> &specs, const Records &records)
{
    std::map<std::string, nlohmann::json> good;
    for (const auto &[index, record] : records)
        if (specs[index].planner.rfind("fault_", 0) != 0)
            good[specs[index].planner + std::to_string(specs[index].seed)] = repeatable(specs[index], record);
    return good;
}

TEST(IsolatedRunner, FaultyPlannersCostOnlyTheirOwnRuns)
{
    std::vector<RunSpec> mixed, good;
    std::uint32_t seed = 0;
    for (const Fault &fault : faultPlanners())
    {
        ++seed;
        good.push_back(goodRun(seed % 2 == 0 ? "rrtconnect" : "bkpiece1", seed));
        mixed.push_back(good.back());
        mixed.push_back(faultyRun(fault));
    }

    Lifeline lifeline;
    const Records records = runEach(mixed, 2);
    EXPECT_TRUE(lifeline.everybodyIsGone());

    for (std::size_t i = 0; i < mixed.size(); i += 2)
    {
        const Fault &fault = faultPlanners()[i / 2];
        const Record &record = records.at(i + 1);
        EXPECT_EQ(toString(record.outcome), toString(fault.outcome)) << fault.planner << ": " << record.reason;
        EXPECT_NE(record.reason.find(fault.reason), std::string::npos) << fault.planner << ": " << record.reason;
        EXPECT_LE(record.output.size(), 4096u) << fault.planner;
        EXPECT_EQ(toString(records.at(i).outcome), "solved") << mixed[i].planner << " " << mixed[i].seed;
    }
    EXPECT_EQ(goodOnes(mixed, records), goodOnes(good, runEach(good, 1)));
}

TEST(IsolatedRunner, KeepsTheLastLinesOfTheOutput)
{
    for (const Fault &fault : faultPlanners())
    {
        if (fault.planner == "fault_segfault")
        {
            EXPECT_EQ(runEach({faultyRun(fault)}, 1).at(0).output.rfind("about to read nothing\n", 0), 0u);
        }
        if (fault.planner == "fault_flood")
        {
            const std::string output = runEach({faultyRun(fault)}, 1).at(0).output;
            EXPECT_EQ(output.size(), 4096u);
            EXPECT_EQ(output.substr(output.size() - 16), "the last line ?\n");
        }
    }
}

TEST(IsolatedRunner, AgreesWithARunInThisProcess)
{
    const RunSpec spec = goodRun("rrtconnect", 77);
    EXPECT_EQ(repeatable(spec, runEach({spec}, 1).at(0)), repeatable(spec, runOnce(spec)));
}

TEST(IsolatedRunner, AWarmUpChangesNoResult)
{
    RunSpec spec = goodRun("bkpiece1", 78);
    const nlohmann::json cold = repeatable(spec, runEach({spec}, 1).at(0));
    spec.warmUp = 0.02;
    EXPECT_EQ(repeatable(spec, runEach({spec}, 1).at(0)), cold);
}

TEST(IsolatedRunner, AKilledRunKeepsTheTimeItTook)
{
    faultPlanners();
    RunSpec spinning = smallRun("fault_spin");
    spinning.timeLimit = 0.2;
    const Record busy = runEach({spinning}, 1).at(0);
    // On a machine that is too busy it is the wall time that ends it.
    EXPECT_TRUE(busy.cpuTime.value() >= spinning.timeLimit + spinning.grace ||
                busy.time.value() >= wallLimit(spinning.timeLimit) + spinning.grace)
        << *busy.cpuTime << " s of CPU, " << *busy.time << " s";

    RunSpec sleeping = smallRun("fault_ignores_limit");
    sleeping.timeLimit = 0.2;
    const Record idle = runEach({sleeping}, 1).at(0);
    EXPECT_GE(idle.time.value(), wallLimit(sleeping.timeLimit) + sleeping.grace);
    EXPECT_LT(idle.cpuTime.value(), sleeping.timeLimit);
}

TEST(IsolatedRunner, SaysWhichCoresARunHadAndWhetherItSharedThem)
{
    const std::size_t cores = usablePhysicalCores().size();
    const auto run = [](std::size_t jobs, bool pin)
    {
        Record result;
        runAll(
            {goodRun("rrtconnect", 1)}, static_cast<int>(jobs),
            [&result](std::size_t, const Record &record) { result = record; }, {}, pin);
        return result;
    };
    EXPECT_FALSE(run(1, true).cpus);  // alone, it may use them all
    EXPECT_FALSE(run(1, true).sharesCore.value());
    EXPECT_TRUE(run(cores + 1, false).sharesCore.value());
    EXPECT_TRUE(run(cores + 1, true).sharesCore.value());
    EXPECT_FALSE(run(cores + 1, false).cpus);
    EXPECT_EQ(run(cores + 1, true).cpus.value(), toText(usablePhysicalCores().front()));
    EXPECT_FALSE(run(cores, true).sharesCore.value());
}

TEST(IsolatedRunner, KeepsARunToItsCores)
{
    const std::vector<CpuList> cores = usablePhysicalCores();
    faultPlanners();
    std::vector<RunSpec> specs(cores.size() + 1, smallRun("fault_tells_cpus"));
    runAll(
        specs, static_cast<int>(specs.size()),
        [](std::size_t, const Record &record) { EXPECT_EQ(record.output, *record.cpus + "\n"); }, {}, true);
}

TEST(IsolatedRunner, StartsRunsInTheGivenOrder)
{
    std::vector<RunSpec> specs;
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
        specs.push_back(goodRun("rrtconnect", seed));
    std::vector<std::size_t> order;
    runAll(specs, 1, [&order](std::size_t index, const Record &) { order.push_back(index); });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(IsolatedRunner, InvalidParametersAreReportedInTheRecord)
{
    RunSpec spec = goodRun("rrtconnect", 1);
    spec.parameters["range"] = "wide";
    const Record record = runEach({spec}, 1).at(0);
    EXPECT_EQ(record.outcome, Outcome::InternalError);
    EXPECT_NE(record.reason.find("range"), std::string::npos) << record.reason;
}

TEST(IsolatedRunner, RefusesToStartWhatCannotBe)
{
    const auto never = [](std::size_t, const Record &)
    {
        FAIL();
    };
    EXPECT_THROW(runAll({goodRun("rrtconnect", 1)}, 0, never), std::invalid_argument);
    EXPECT_THROW(runAll({goodRun("rrtconnect", 1), goodRun("no_such_planner", 1)}, 1, never), std::invalid_argument);
    runAll({}, 1, never);
}

TEST(IsolatedRunner, StoppingKillsTheRunsInFlight)
{
    faultPlanners();
    RunSpec endless = smallRun("fault_ignores_limit");
    endless.timeLimit = 1000.0;
    Lifeline lifeline;
    int records = 0;
    runAll(
        {endless, goodRun("rrtconnect", 1), endless}, 2, [&records](std::size_t, const Record &) { ++records; },
        [&records] { return records > 0; });
    EXPECT_EQ(records, 1);
    EXPECT_TRUE(lifeline.everybodyIsGone());
}

TEST(IsolatedRunner, AnExceptionOfTheCallerLeavesNoProcessBehind)
{
    faultPlanners();
    RunSpec endless = smallRun("fault_ignores_limit");
    endless.timeLimit = 1000.0;
    Lifeline lifeline;
    EXPECT_THROW(runAll({endless, goodRun("rrtconnect", 1)}, 2,
                        [](std::size_t, const Record &) { throw std::runtime_error("disk full"); }),
                 std::runtime_error);
    EXPECT_TRUE(lifeline.everybodyIsGone());
}

TEST(IsolatedRunner, RunsDieWithTheirSupervisor)
{
    faultPlanners();
    RunSpec endless = smallRun("fault_ignores_limit");
    endless.timeLimit = 1000.0;
    Lifeline lifeline;
    faultSignal = lifeline.writeEnd();
    const pid_t supervisor = fork();
    if (supervisor == 0)
    {
        runAll({endless}, 1, [](std::size_t, const Record &) {});
        _exit(0);
    }
    EXPECT_EQ(lifeline.readByte(), '!');  // its run is in solve()
    kill(supervisor, SIGKILL);
    waitpid(supervisor, nullptr, 0);
    faultSignal = -1;
    EXPECT_TRUE(lifeline.everybodyIsGone());
}
}  // namespace
}  // namespace narrows
