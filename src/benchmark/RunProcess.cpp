// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/RunProcess.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "benchmark/RunChild.h"
#include "benchmark/SolveLimit.h"

namespace narrows
{
namespace
{
constexpr double warmUpGrace = 10.0;    // seconds, for building besides
constexpr double untimedLimit = 120.0;  // seconds for stages that are not the planner's; only to end at all
constexpr std::size_t tailSize = 4096;  // bytes of stdout and stderr that are kept
constexpr std::size_t largestResult = std::size_t(256) << 20;
constexpr std::size_t readsAtATime = 64;  // so that a flood on one pipe does not starve the others

/// Wall seconds that a stage may take at most.
double limitOf(RunStage stage, const RunSpec &spec)
{
    switch (stage)
    {
        case RunStage::Solving:
            return wallLimit(spec.timeLimit) + spec.grace;
        case RunStage::WarmUp:
            return spec.warmUp + wallLimit(spec.timeLimit) + warmUpGrace;
        case RunStage::Building:
        case RunStage::Judging:
            break;
    }
    return untimedLimit;
}

/// CPU time that all threads of a process have used so far; 0 if it is gone.
double cpuSecondsOf(pid_t process)
{
    clockid_t clock{};
    timespec used{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0)
        return 0.0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

RunProcess::Clock::duration wallTime(double seconds)
{
    return std::chrono::duration_cast<RunProcess::Clock::duration>(std::chrono::duration<double>(seconds));
}

struct Pipe
{
    int readEnd = -1;
    int writeEnd = -1;

    Pipe()
    {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw std::system_error(errno, std::generic_category(), "pipe");
        readEnd = ends[0];
        writeEnd = ends[1];
        fcntl(readEnd, F_SETFL, O_NONBLOCK);
    }
    ~Pipe()
    {
        if (readEnd >= 0)
            close(readEnd);
        close(writeEnd);
    }
    Pipe(const Pipe &) = delete;
    Pipe &operator=(const Pipe &) = delete;

    int takeReadEnd() { return std::exchange(readEnd, -1); }
};

/// Passes on what the pipe holds; closes it at its end.
template <typename Take>
void drain(int &pipe, std::size_t reads, const Take &take)
{
    std::array<char, 65536> buffer{};
    for (std::size_t i = 0; pipe >= 0 && i < reads; ++i)
    {
        const ssize_t size = read(pipe, buffer.data(), buffer.size());
        if (size > 0)
            take(buffer.data(), static_cast<std::size_t>(size));
        else if (size < 0 && errno == EAGAIN)
            return;
        else if (size == 0 || errno != EINTR)
        {
            close(pipe);
            pipe = -1;
        }
    }
}
}  // namespace

RunProcess::RunProcess(const RunSpec &spec, std::size_t index, std::size_t slot, const CpuList &cpus)
  : spec_(spec), index_(index), slot_(slot)
{
    Pipe result, output;
    // What waits in our buffers would be written a second time if the run's process flushed its copy of them.
    std::fflush(nullptr);
    const pid_t supervisor = getpid();
    pid_ = fork();
    if (pid_ < 0)
        throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ == 0)
        liveAsRun(spec, {result.writeEnd, output.writeEnd}, cpus, supervisor);
    setpgid(pid_, pid_);  // as the process itself does: whoever comes first
    result_ = result.takeReadEnd();
    output_ = output.takeReadEnd();
    enter(RunStage::Building);
}

RunProcess::~RunProcess()
{
    if (pid_ > 0)
    {
        ::kill(-pid_, SIGKILL);
        while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR)
            continue;
    }
    for (const int pipe : {result_, output_})
        if (pipe >= 0)
            close(pipe);
}

void RunProcess::enter(RunStage stage)
{
    stage_ = stage;
    stageStart_ = Clock::now();
    stageStartCpu_ = cpuSecondsOf(pid_);
    lastMoment_ = stageStart_ + wallTime(limitOf(stage, spec_));
    deadline_ = stage == RunStage::Solving ? nextLook(0.0) : lastMoment_;
}

RunProcess::Clock::time_point RunProcess::nextLook(double cpuUsed) const
{
    constexpr double least = 0.001;  // seconds
    // With all cores at work for it, the process can be over its limit no earlier than this.
    const double left = (spec_.timeLimit + spec_.grace - cpuUsed) / std::max(1U, std::thread::hardware_concurrency());
    return std::min(lastMoment_, Clock::now() + wallTime(std::max(left, least)));
}

void RunProcess::readAll()
{
    readResult();
    readOutput();
}

void RunProcess::readResult()
{
    drain(result_, readsAtATime,
          [this](const char *data, std::size_t size)
          {
              if (resultText_.size() + size <= largestResult)
                  resultText_.append(data, size);
              else
                  kill(Stop::Oversized);
              takeMarks();
          });
}

void RunProcess::readOutput()
{
    drain(output_, readsAtATime,
          [this](const char *data, std::size_t size)
          {
              tail_.append(data, size);
              if (tail_.size() > tailSize)
                  tail_.erase(0, tail_.size() - tailSize);
          });
}

void RunProcess::takeMarks()
{
    std::size_t taken = 0;
    for (; !resultBegun_ && taken < resultText_.size(); ++taken)
    {
        const char mark = resultText_[taken];
        resultBegun_ = mark == resultMark;
        for (const RunStage stage : {RunStage::Building, RunStage::WarmUp, RunStage::Solving, RunStage::Judging})
            if (mark == toMark(stage))
                enter(stage);
    }
    resultText_.erase(0, taken);
}

void RunProcess::kill(Stop why)
{
    if (stop_ != Stop::None)
        return;
    stop_ = why;
    deadline_ = Clock::time_point::max();
    stageSeconds_ = std::chrono::duration<double>(Clock::now() - stageStart_).count();
    stageCpuSeconds_ = cpuSecondsOf(pid_) - stageStartCpu_;
    ::kill(-pid_, SIGKILL);
}

void RunProcess::enforceDeadline(Clock::time_point now)
{
    if (stop_ != Stop::None || now < deadline_)
        return;
    const double cpuUsed = cpuSecondsOf(pid_) - stageStartCpu_;
    if (stage_ == RunStage::Solving && now < lastMoment_ && cpuUsed < spec_.timeLimit + spec_.grace)
        deadline_ = nextLook(cpuUsed);
    else
        kill(Stop::Overdue);
}

bool RunProcess::hasEnded()
{
    // The dead process is left in place while its group is killed, so that its number cannot belong to somebody else
    // yet.
    siginfo_t info{};
    if (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0)
        return false;
    ::kill(-pid_, SIGKILL);
    waitpid(pid_, &waitStatus_, 0);
    pid_ = -1;
    // A pipe holds no more than a few of these reads.
    readAll();
    return true;
}

bool RunProcess::wasKilledFromOutside() const
{
    if (stop_ != Stop::None || !WIFSIGNALED(waitStatus_))
        return false;
    const int number = WTERMSIG(waitStatus_);
    return number == SIGKILL || number == SIGTERM || number == SIGINT || number == SIGHUP;
}
}  // namespace narrows
