// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/IsolatedRunner.h"

#include <algorithm>
#include <csignal>
#include <list>
#include <map>
#include <stdexcept>
#include <system_error>

#include <poll.h>

#include "benchmark/Cores.h"
#include "benchmark/Orphans.h"
#include "benchmark/PreparedRun.h"
#include "benchmark/RunProcess.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
using Clock = RunProcess::Clock;

/// Makes the end of a child interrupt `wait()`, and nothing else: SIGCHLD is blocked except while waiting, so that none
/// can slip in between looking and waiting.
class ChildSignal
{
public:
    ChildSignal()
    {
        struct sigaction interrupt
        {
        };
        interrupt.sa_handler = [](int) {
        };
        sigaction(SIGCHLD, &interrupt, &oldAction_);
        sigset_t child;
        sigemptyset(&child);
        sigaddset(&child, SIGCHLD);
        sigprocmask(SIG_BLOCK, &child, &oldMask_);
    }
    ~ChildSignal()
    {
        sigprocmask(SIG_SETMASK, &oldMask_, nullptr);
        sigaction(SIGCHLD, &oldAction_, nullptr);
    }
    ChildSignal(const ChildSignal &) = delete;
    ChildSignal &operator=(const ChildSignal &) = delete;

    void wait(std::vector<pollfd> &descriptors, Clock::duration timeout) const
    {
        using namespace std::chrono;
        const nanoseconds left = std::max(nanoseconds(0), duration_cast<nanoseconds>(timeout));
        const timespec time{static_cast<time_t>(left.count() / 1'000'000'000), left.count() % 1'000'000'000};
        sigset_t mask = oldMask_;
        sigdelset(&mask, SIGCHLD);
        ppoll(descriptors.data(), descriptors.size(), &time, &mask);
    }

private:
    struct sigaction oldAction_
    {
    };
    sigset_t oldMask_{};
};

/// What runs at a time share, or do not.
class Slots
{
public:
    Slots(std::size_t count, bool pin)
    {
        const std::vector<CpuList> cores = usablePhysicalCores();
        const bool threadsInCores =
            std::any_of(cores.begin(), cores.end(), [](const CpuList &core) { return core.size() > 1; });
        shareCores_ = count > cores.size() || (count > 1 && !pin && threadsInCores);
        if (pin && count > 1)
            shares_ = sharesOf(cores, count);
        for (std::size_t slot = count; slot-- > 0;)
            free_.push_back(slot);
    }

    bool anyFree() const { return !free_.empty(); }
    std::size_t take()
    {
        const std::size_t slot = free_.back();
        free_.pop_back();
        return slot;
    }
    void giveBack(std::size_t slot) { free_.push_back(slot); }

    /// None: any.
    CpuList cpus(std::size_t slot) const { return shares_.empty() ? CpuList() : shares_[slot]; }

    void describe(std::size_t slot, Record &record) const
    {
        record.sharesCore = shareCores_;
        if (!shares_.empty())
            record.cpus = toText(shares_[slot]);
    }

private:
    std::vector<CpuList> shares_;  ///< by slot; none if runs are not pinned
    std::vector<std::size_t> free_;
    bool shareCores_ = false;
};

class Supervisor
{
public:
    Supervisor(const std::vector<RunSpec> &specs, std::size_t jobs, bool pin,
               const std::function<void(std::size_t, const Record &)> &onRecord)
      : specs_(specs), onRecord_(onRecord), slots_(jobs, pin)
    {
    }

    bool isDone() const { return !anyWaiting() && running_.empty(); }

    void start()
    {
        while (anyWaiting() && slots_.anyFree())
        {
            const std::size_t index = takeNext();
            const std::size_t slot = slots_.take();
            try
            {
                running_.emplace_back(specs_[index], index, slot, slots_.cpus(slot));
            }
            catch (const std::system_error &error)
            {
                slots_.giveBack(slot);
                Record record = announce(specs_[index]);
                record.outcome = Outcome::InternalError;
                record.reason = error.what();
                onRecord_(index, record);
            }
        }
    }

    void wait()
    {
        std::vector<pollfd> descriptors;
        Clock::time_point wakeUp = Clock::now() + longestWait;
        for (const RunProcess &process : running_)
        {
            for (const int pipe : {process.resultPipe(), process.outputPipe()})
                if (pipe >= 0)
                    descriptors.push_back({pipe, POLLIN, 0});
            wakeUp = std::min(wakeUp, process.deadline());
        }
        signal_.wait(descriptors, wakeUp - Clock::now());
    }

    void collect()
    {
        for (auto process = running_.begin(); process != running_.end();)
        {
            process->readAll();
            process->enforceDeadline(Clock::now());
            if (process->hasEnded())
                process = finish(process);
            else
                ++process;
        }
    }

private:
    static constexpr std::chrono::milliseconds longestWait{500};  // how late a request to stop may be noticed

    static constexpr int mostKills = 3;  // by others, of one run; who always is, gets a record that says so

    bool anyWaiting() const { return next_ < specs_.size() || !again_.empty(); }

    std::size_t takeNext()
    {
        if (again_.empty())
            return next_++;
        const std::size_t index = again_.back();
        again_.pop_back();
        return index;
    }

    std::list<RunProcess>::iterator finish(std::list<RunProcess>::iterator process)
    {
        const std::size_t index = process->index();
        Record record = process->record();
        const bool onceMore = process->wasKilledFromOutside() && ++kills_[index] < mostKills;
        slots_.describe(process->slot(), record);
        slots_.giveBack(process->slot());
        const auto next = running_.erase(process);
        std::vector<pid_t> ours;
        for (const RunProcess &other : running_)
            ours.push_back(other.pid());
        orphans_.kill(ours);
        if (onceMore)
            again_.push_back(index);
        else
            onRecord_(index, record);
        return next;
    }

    const std::vector<RunSpec> &specs_;
    const std::function<void(std::size_t, const Record &)> &onRecord_;
    std::size_t next_ = 0;
    std::vector<std::size_t> again_;    // runs to be repeated
    std::map<std::size_t, int> kills_;  // by others, so far
    ChildSignal signal_;
    Orphans orphans_;  // goes after the runs, whose ends it collects
    Slots slots_;
    std::list<RunProcess> running_;
};
}  // namespace

void runAll(const std::vector<RunSpec> &specs, int jobs,
            const std::function<void(std::size_t, const Record &)> &onRecord, const std::function<bool()> &stop,
            bool pin)
{
    if (jobs < 1)
        throw std::invalid_argument("jobs must be at least 1");
    for (const RunSpec &spec : specs)
        findPlanner(spec.planner);
    Supervisor supervisor(specs, static_cast<std::size_t>(jobs), pin, onRecord);
    while (!supervisor.isDone() && !(stop && stop()))
    {
        supervisor.start();
        supervisor.wait();
        supervisor.collect();
    }
}
}  // namespace narrows
