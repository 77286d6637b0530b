// SPDX-License-Identifier: BSD-3-Clause
// What the isolated runner costs and how well it keeps its limits: RunnerBench [RUNS]. Planners that never end of
// themselves are timed on a machine whose every core is busy with something else. Prints percentiles; times in ms,
// memory in MB.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "benchmark/Cores.h"
#include "benchmark/IsolatedRunner.h"
#include "benchmark/ResultStore.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
/// Never solves anything; `turn` is what it does over and over.
class Endless : public ob::Planner
{
public:
    Endless(const ob::SpaceInformationPtr &si, bool polite, std::function<void()> turn)
      : ob::Planner(si, "Endless"), polite_(polite), turn_(std::move(turn))
    {
    }

    using ob::Planner::solve;
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
    {
        while (!polite_ || !ptc)
            turn_();
        return ob::PlannerStatus::TIMEOUT;
    }

private:
    bool polite_;
    std::function<void()> turn_;
};

void work()
{
    for (volatile int i = 0; i < 1000; i = i + 1)
        continue;
}

void eat()
{
    constexpr std::size_t piece = std::size_t(256) << 10;
    static std::vector<std::unique_ptr<char[]>> eaten;
    eaten.push_back(std::make_unique<char[]>(piece));  // zeros, so that it is there
}

void add(const std::string &name, bool polite, const std::function<void()> &turn)
{
    PlannerEntry entry;
    entry.name = name;
    entry.make = [=](const PlannerContext &context)
    {
        return std::make_shared<Endless>(context.si, polite, turn);
    };
    registerPlanner(entry);
}

/// Keeps every core busy.
class Load
{
public:
    Load()
    {
        for (unsigned int i = 0; i < std::thread::hardware_concurrency(); ++i)
        {
            const pid_t child = fork();
            if (child == 0)
                while (true)
                    work();
            children_.push_back(child);
        }
    }
    ~Load()
    {
        for (const pid_t child : children_)
        {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }
    Load(const Load &) = delete;
    Load &operator=(const Load &) = delete;

private:
    std::vector<pid_t> children_;
};

void print(const char *what, std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const auto at = [&values](double share)
    {
        return values.empty() ? 0.0 : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    std::printf("%-52s %5zu %9.3f %9.3f %9.3f %9.3f\n", what, values.size(), at(0.5), at(0.9), at(0.99), at(1.0));
    std::fflush(stdout);
}

Experiment experiment(const std::string &folder, const std::string &settings)
{
    const std::string file = folder + "/bench.cfg";
    std::ofstream(file) << "[problem]\nname = bench\nscenario = " NARROWS_SOURCE_DIR
                           "/experiments/scenarios/gap_small.yaml\n[benchmark]\nwarm_up = 0\n"
                        << settings;
    return readExperiment(file);
}

/// From one record to the next, but for solve(): fork, building, judging, pipe, database.
void measureOverhead(const std::string &folder, const std::string &runs)
{
    const Experiment plan = experiment(folder, "save_paths = all\nrun_count = " + runs + "\n[planner]\nrrtconnect =\n");
    const std::vector<RunSpec> specs = expand(plan);
    ResultStore store = ResultStore::create(folder + "/overhead.db", plan, "isolated");
    store.beginSession(captureEnvironment(1));
    using Clock = std::chrono::steady_clock;
    Clock::time_point last = Clock::now();
    std::vector<double> overheads;
    runAll(specs, 1,
           [&](std::size_t index, const Record &record)
           {
               store.add(specs[index], record, SavePaths::All);
               const Clock::time_point now = Clock::now();
               overheads.push_back(1e3 * (std::chrono::duration<double>(now - last).count() - record.time.value_or(0)));
               last = now;
           });
    print("overhead of a run beyond solve()", overheads);
}

/// CPU time that planners had beyond their limit.
void measureTime(const std::string &folder, const std::string &runs, const std::string &planner)
{
    const Experiment plan =
        experiment(folder, "time_limit = 0.2\nrun_count = " + runs + "\n[planner]\n" + planner + " =\n");
    std::vector<double> cpu;
    runAll(
        expand(plan), static_cast<int>(usablePhysicalCores().size()),
        [&](std::size_t, const Record &record) { cpu.push_back(1e3 * (*record.cpuTime - plan.timeLimit)); }, {}, true);
    print(("CPU time over the limit, " + planner).c_str(), cpu);
}

void measureMemory(const std::string &folder, const std::string &runs)
{
    const Experiment plan = experiment(folder, "mem_limit = 128\nrun_count = " + runs + "\n[planner]\nglutton =\n");
    std::vector<double> memory;
    runAll(
        expand(plan), static_cast<int>(usablePhysicalCores().size()),
        [&](std::size_t, const Record &record) { memory.push_back(*record.peakMemoryKb / 1024.0 - plan.memoryLimit); },
        {}, true);
    print("memory over the limit, glutton", memory);
}
}  // namespace
}  // namespace narrows

int main(int argc, char **argv)
{
    using namespace narrows;
    const std::string runs = argc > 1 ? argv[1] : "200";
    const std::string folder = std::filesystem::temp_directory_path() / ("narrows_runner" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    add("polite", true, work);
    add("rude", false, work);
    add("glutton", false, eat);
    std::printf("%-52s %5s %9s %9s %9s %9s\n", "", "runs", "median", "90 %", "99 %", "most");
    measureOverhead(folder, runs);
    {
        const Load load;
        measureTime(folder, runs, "polite");
        measureTime(folder, runs, "rude");
        measureMemory(folder, runs);
    }
    std::filesystem::remove_all(folder);
    return 0;
}
