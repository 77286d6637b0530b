// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/RunChild.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "benchmark/AddressSanitizer.h"
#include "benchmark/PreparedRun.h"
#include "benchmark/ProcessUsage.h"

namespace narrows
{
namespace
{
constexpr bool addressSpaceLimited = !NARROWS_ADDRESS_SANITIZER;  // which reserves terabytes of it

using Resource = decltype(RLIMIT_AS);

void setSoftLimit(Resource resource, rlim_t value)
{
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min(value, limit.rlim_max);
    setrlimit(resource, &limit);
}

/// The supervisor's way with signals is its own.
void resetSignals()
{
    for (const int number : {SIGCHLD, SIGINT, SIGTERM, SIGPIPE})
        std::signal(number, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

void limitMemory(double megabytes)
{
    if (addressSpaceLimited)
        setSoftLimit(RLIMIT_AS, addressSpaceBytes() + static_cast<rlim_t>(megabytes * 1024.0 * 1024.0));
}

/// What the supervisor does not see to. No RLIMIT_CPU: with one, Linux takes the process's CPU clock from the
/// scheduler's last tick, up to 4 ms ago, and books whole runs as 0. The supervisor kills by wall time, and the kernel
/// kills us when it dies, so nothing runs on for ever.
void limitTheRest()
{
    constexpr rlim_t largestFile = 64u << 20;
    setSoftLimit(RLIMIT_CORE, 0);
    setSoftLimit(RLIMIT_FSIZE, largestFile);
}

void redirectStandardStreams(int output)
{
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    close(nothing);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    // The last lines before a crash are the ones that matter, so none may wait in a buffer.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    std::cout.setf(std::ios::unitbuf);
}

void send(int pipe, const char *data, std::size_t size)
{
    while (size > 0)
    {
        const ssize_t written = write(pipe, data, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            _exit(EXIT_FAILURE);  // nobody listens any more
        data += written;
        size -= static_cast<std::size_t>(written);
    }
}

Record run(const RunSpec &spec, int pipe)
{
    const auto onStage = [&spec, pipe](RunStage stage)
    {
        // The limit is the planner's: judging must not fail because a solved run has come close to it.
        if (stage == RunStage::Judging)
            setSoftLimit(RLIMIT_AS, RLIM_INFINITY);
        else if (stage == RunStage::WarmUp || (stage == RunStage::Building && spec.warmUp <= 0.0))
            limitMemory(spec.memoryLimit);
        const char mark = toMark(stage);
        send(pipe, &mark, 1);
    };
    try
    {
        return runOnce(spec, onStage);
    }
    catch (const std::exception &error)
    {
        Record record = announce(spec);
        record.outcome = Outcome::InternalError;
        record.reason = error.what();
        return record;
    }
}
}  // namespace

char toMark(RunStage stage)
{
    switch (stage)
    {
        case RunStage::Building:
            return 'B';
        case RunStage::WarmUp:
            return 'W';
        case RunStage::Solving:
            return 'S';
        case RunStage::Judging:
            return 'J';
    }
    return '?';
}

void liveAsRun(const RunSpec &spec, const ChildPipes &pipes, const CpuList &cpus, int supervisor) noexcept
{
    resetSignals();
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Children of children that lose their parents stay ours, and fall to the supervisor when we end.
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    keepTo(cpus);
    if (getppid() != supervisor)
        _exit(EXIT_FAILURE);
    redirectStandardStreams(pipes.output);
    limitTheRest();

    const Record record = run(spec, pipes.result);
    setSoftLimit(RLIMIT_AS, RLIM_INFINITY);
    const std::string json = resultMark + toJson(spec, record);
    send(pipes.result, json.data(), json.size());
    std::cout.flush();
    std::fflush(nullptr);
    // No destructors: they would do again what the parent's exit will do.
    _exit(EXIT_SUCCESS);
}
}  // namespace narrows
