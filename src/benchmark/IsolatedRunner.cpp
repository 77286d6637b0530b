// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/IsolatedRunner.h"

#include <algorithm>
#include <csignal>
#include <list>
#include <stdexcept>
#include <system_error>

#include <poll.h>

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

class Supervisor
{
public:
    Supervisor(const std::vector<RunSpec> &specs, std::size_t jobs,
               const std::function<void(std::size_t, const Record &)> &onRecord)
      : specs_(specs), jobs_(jobs), onRecord_(onRecord)
    {
    }

    bool isDone() const { return next_ == specs_.size() && running_.empty(); }

    void start()
    {
        while (next_ < specs_.size() && running_.size() < jobs_)
        {
            const std::size_t index = next_++;
            try
            {
                running_.emplace_back(specs_[index], index);
            }
            catch (const std::system_error &error)
            {
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
            {
                const std::size_t index = process->index();
                const Record record = process->record();
                process = running_.erase(process);
                onRecord_(index, record);
            }
            else
                ++process;
        }
    }

private:
    static constexpr std::chrono::milliseconds longestWait{500};  // how late a request to stop may be noticed

    const std::vector<RunSpec> &specs_;
    std::size_t jobs_;
    const std::function<void(std::size_t, const Record &)> &onRecord_;
    std::size_t next_ = 0;
    ChildSignal signal_;
    std::list<RunProcess> running_;
};
}  // namespace

void runAll(const std::vector<RunSpec> &specs, int jobs,
            const std::function<void(std::size_t, const Record &)> &onRecord, const std::function<bool()> &stop)
{
    if (jobs < 1)
        throw std::invalid_argument("jobs must be at least 1");
    for (const RunSpec &spec : specs)
        findPlanner(spec.planner);
    Supervisor supervisor(specs, static_cast<std::size_t>(jobs), onRecord);
    while (!supervisor.isDone() && !(stop && stop()))
    {
        supervisor.start();
        supervisor.wait();
        supervisor.collect();
    }
}
}  // namespace narrows
