// SPDX-License-Identifier: BSD-3-Clause
#include "FaultPlanners.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>

#include <ompl/geometric/PathGeometric.h>
#include <unistd.h>

#include "benchmark/AddressSanitizer.h"
#include "benchmark/Cores.h"
#include "planners/PlannerFactory.h"
#include "spaces/PlanarArmStateSpace.h"

#if NARROWS_ADDRESS_SANITIZER
/// Bad accesses, which are meant here, end a process as they do without the sanitizer: by their signal.
extern "C" const char *__asan_default_options()
{
    return "handle_segv=0";
}
#endif

namespace narrows
{
int faultSignal = -1;

namespace
{
constexpr bool underSanitizer = NARROWS_ADDRESS_SANITIZER;

/// Gets the problem and does its one thing in solve().
class FaultPlanner : public ob::Planner
{
public:
    using Deed = std::function<ob::PlannerStatus(FaultPlanner &)>;

    FaultPlanner(const ob::SpaceInformationPtr &si, Deed deed) : ob::Planner(si, "Fault"), deed_(std::move(deed)) {}

    using ob::Planner::solve;
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &) override { return deed_(*this); }

    std::shared_ptr<og::PathGeometric> straightPath()
    {
        auto path = std::make_shared<og::PathGeometric>(si_);
        path->append(pdef_->getStartState(0));
        path->append(pis_.nextGoal());
        return path;
    }

    ob::PlannerStatus claim(const ob::PathPtr &path)
    {
        pdef_->addSolutionPath(path);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }

    ob::PlannerStatus claimEmptyPath() { return claim(std::make_shared<og::PathGeometric>(si_)); }

private:
    Deed deed_;
};

ob::PlannerStatus throwLogicError(FaultPlanner &)
{
    throw std::logic_error("a logic error");
}

ob::PlannerStatus throwInt(FaultPlanner &)
{
    throw 42;
}

ob::PlannerStatus segfault(FaultPlanner &)
{
    std::cout << "about to read nothing\n";
    volatile int *volatile nothing = nullptr;
    return *nothing == 0 ? ob::PlannerStatus::ABORT : ob::PlannerStatus::CRASH;
}

ob::PlannerStatus abortProcess(FaultPlanner &)
{
    std::abort();
}

void eatMemory()
{
    constexpr std::size_t piece = std::size_t(1) << 20;
    std::vector<std::unique_ptr<char[]>> eaten;
    while (true)
        eaten.push_back(std::make_unique<char[]>(piece));
}

ob::PlannerStatus allocateWithoutEnd(FaultPlanner &)
{
    eatMemory();
    return ob::PlannerStatus::ABORT;
}

/// Where nobody can catch it, the failure of an allocation ends the process.
ob::PlannerStatus allocateInThread(FaultPlanner &)
{
    std::thread(eatMemory).join();
    return ob::PlannerStatus::ABORT;
}

ob::PlannerStatus ignoreLimit(FaultPlanner &)
{
    if (faultSignal >= 0 && write(faultSignal, "!", 1) != 1)
        std::abort();
    while (true)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

ob::PlannerStatus spin(FaultPlanner &)
{
    volatile std::uint64_t turns = 0;
    while (true)
        turns = turns + 1;
}

ob::PlannerStatus goThroughObstacle(FaultPlanner &planner)
{
    return planner.claim(planner.straightPath());
}

ob::PlannerStatus returnNaN(FaultPlanner &planner)
{
    const std::shared_ptr<og::PathGeometric> path = planner.straightPath();
    path->getState(1)->as<PlanarArmStateSpace::StateType>()->values[0] = std::numeric_limits<double>::quiet_NaN();
    return planner.claim(path);
}

ob::PlannerStatus claimNothing(FaultPlanner &)
{
    return ob::PlannerStatus::EXACT_SOLUTION;
}

ob::PlannerStatus floodOutput(FaultPlanner &)
{
    const std::string line(1000, '~');
    for (int i = 0; i < 20000; ++i)
        std::cout << line << '\n';
    std::cout << "the last line \xff\n";
    return ob::PlannerStatus::ABORT;
}

ob::PlannerStatus exitSilently(FaultPlanner &)
{
    std::_Exit(0);
}

constexpr unsigned int lifetime = 600;  // seconds; an end of what is left behind, should the runner fail to make one

/// Children and threads that outlive solve().
ob::PlannerStatus spawnChildren(FaultPlanner &)
{
    constexpr int children = 50;
    constexpr int threads = 2;
    for (int i = 0; i < children; ++i)
        if (fork() == 0)
        {
            sleep(lifetime);
            _exit(0);
        }
    for (int i = 0; i < threads; ++i)
        std::thread([] { std::this_thread::sleep_for(std::chrono::seconds(lifetime)); }).detach();
    return ob::PlannerStatus::ABORT;
}

/// A daemon: in a session of its own, and the child of nobody who is still there.
ob::PlannerStatus detachChild(FaultPlanner &)
{
    if (fork() == 0)
    {
        setsid();
        if (fork() == 0)
            sleep(lifetime);
        _exit(0);
    }
    return ob::PlannerStatus::ABORT;
}

ob::PlannerStatus tellCpus(FaultPlanner &)
{
    CpuList cpus;
    for (const CpuList &core : usablePhysicalCores())
        cpus.insert(cpus.end(), core.begin(), core.end());
    std::sort(cpus.begin(), cpus.end());
    std::cout << toText(cpus) << '\n';
    return ob::PlannerStatus::ABORT;
}

/// Writes over the heap's own notes, before and after a piece of memory; glibc notices when that is given back.
ob::PlannerStatus corruptHeap(FaultPlanner &)
{
    constexpr int size = 64;
    constexpr int header = 8;
    auto *volatile piece = static_cast<volatile unsigned char *>(std::malloc(size));
    for (int i = -header; i < 2 * size; ++i)
        piece[i] = 0xff;
    std::free(const_cast<unsigned char *>(piece));
    return ob::PlannerStatus::ABORT;
}

/// Ends with the stack, long before the count is negative. The frames must not be optimised into a loop.
__attribute__((noinline)) int recurse(volatile int *outer)
{
    volatile int inner[1000];
    inner[0] = *outer + 1;
    if (inner[0] < 0)
        return 0;
    return recurse(inner) + inner[0];
}

ob::PlannerStatus overflowStack(FaultPlanner &)
{
    volatile int first = 0;
    return recurse(&first) == 0 ? ob::PlannerStatus::ABORT : ob::PlannerStatus::CRASH;
}

void add(std::vector<Fault> &faults, const Fault &fault, const FaultPlanner::Deed &deed)
{
    PlannerEntry entry;
    entry.name = fault.planner;
    entry.summary = "does something no planner should";
    entry.make = [deed](const PlannerContext &context)
    {
        return std::make_shared<FaultPlanner>(context.si, deed);
    };
    registerPlanner(entry);
    faults.push_back(fault);
}

std::vector<Fault> registerAll()
{
    std::vector<Fault> faults;
    add(faults, {"fault_logic_error", Outcome::Crash, "a logic error"}, throwLogicError);
    add(faults, {"fault_int", Outcome::Crash, "unknown exception"}, throwInt);
    add(faults, {"fault_segfault", Outcome::Crash, "SIGSEGV"}, segfault);
    add(faults, {"fault_stack", Outcome::Crash, "SIGSEGV"}, overflowStack);
    add(faults, {"fault_abort", Outcome::Crash, "SIGABRT"}, abortProcess);
    add(faults, {"fault_ignores_limit", Outcome::Timeout, "killed: ignored the limit"}, ignoreLimit);
    add(faults, {"fault_collides", Outcome::Unverified, "collision: segment 0"}, goThroughObstacle);
    add(faults, {"fault_nan", Outcome::Unverified, "not_finite"}, returnNaN);
    add(faults, {"fault_empty_path", Outcome::Unverified, "empty_path"},
        [](FaultPlanner &planner) { return planner.claimEmptyPath(); });
    add(faults, {"fault_no_path", Outcome::Unverified, "no_path"}, claimNothing);
    add(faults, {"fault_flood", Outcome::NoSolution, "abort"}, floodOutput);
    add(faults, {"fault_exit", Outcome::Crash, "exited without a result (code 0)"}, exitSilently);
    add(faults, {"fault_children", Outcome::NoSolution, "abort"}, spawnChildren);
    add(faults, {"fault_tells_cpus", Outcome::NoSolution, "abort"}, tellCpus);
    add(faults, {"fault_daemon", Outcome::NoSolution, "abort"}, detachChild);
    add(faults, {"fault_spin", Outcome::Timeout, "killed: ignored the limit"}, spin);
    if (!underSanitizer)
    {
        add(faults, {"fault_memory", Outcome::Memory, "std::bad_alloc"}, allocateWithoutEnd);
        add(faults, {"fault_heap", Outcome::Crash, "SIG"}, corruptHeap);
        add(faults, {"fault_memory_thread", Outcome::Memory, "SIGABRT"}, allocateInThread);
    }
    return faults;
}
}  // namespace

const std::vector<Fault> &faultPlanners()
{
    static const std::vector<Fault> faults = registerAll();
    return faults;
}
}  // namespace narrows
