// SPDX-License-Identifier: BSD-3-Clause
// What a run's process leaves as its record.
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <sys/wait.h>

#include "benchmark/PreparedRun.h"
#include "benchmark/RunProcess.h"

namespace narrows
{
namespace
{
/// "SIGSEGV"
std::string signalName(int number)
{
    const char *name = sigabbrev_np(number);
    return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
}

/// Whatever a process has written, as text that terminals, databases and JSON take.
std::string printable(std::string bytes)
{
    for (char &byte : bytes)
        if (byte != '\n' && byte != '\t' && (byte < ' ' || byte > '~'))
            byte = '?';
    return bytes;
}
}  // namespace

Record RunProcess::record() const
{
    Record record;
    try
    {
        record = stop_ == Stop::None ? fromEnd() : fromKill();
    }
    catch (const std::invalid_argument &error)
    {
        record = announce(spec_);
        record.outcome = Outcome::Crash;
        record.reason = printable(fmt::format("malformed result: {}", error.what()));
    }
    record.output = printable(tail_);
    return record;
}

Record RunProcess::fromEnd() const
{
    if (WIFEXITED(waitStatus_) && WEXITSTATUS(waitStatus_) == EXIT_SUCCESS && resultBegun_)
        return recordFromJson(resultText_);

    Record record = announce(spec_);
    record.outcome = Outcome::Crash;
    if (!WIFSIGNALED(waitStatus_))
    {
        record.reason = fmt::format("exited without a result (code {})", WEXITSTATUS(waitStatus_));
        return record;
    }
    const int number = WTERMSIG(waitStatus_);
    record.reason = signalName(number);
    // An allocation that fails where no exception can be caught aborts; a system out of memory kills.
    if (number == SIGKILL || (number == SIGABRT && tail_.find("std::bad_alloc") != std::string::npos))
        record.outcome = Outcome::Memory;
    return record;
}

Record RunProcess::fromKill() const
{
    Record record = announce(spec_);
    if (stop_ == Stop::Oversized)
    {
        record.outcome = Outcome::Crash;
        record.reason = "oversized result";
        return record;
    }
    switch (stage_)
    {
        case RunStage::Solving:
            record.outcome = Outcome::Timeout;
            record.reason = "killed: ignored the limit";
            record.time = stageSeconds_;
            record.cpuTime = stageCpuSeconds_;
            break;
        case RunStage::WarmUp:
            record.outcome = Outcome::Timeout;
            record.reason = "killed: ignored the limit of the warm-up";
            break;
        case RunStage::Building:
            record.outcome = Outcome::Timeout;
            record.reason = "killed: setup did not end";
            break;
        case RunStage::Judging:
            record.outcome = Outcome::InternalError;
            record.reason = "killed: judging the solution did not end";
            break;
    }
    return record;
}
}  // namespace narrows
