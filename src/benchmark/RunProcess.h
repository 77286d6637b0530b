// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include <sys/types.h>

#include "benchmark/Cores.h"
#include "benchmark/Record.h"
#include "benchmark/RunOnce.h"

namespace narrows
{
/// One run in a process of its own, seen from the supervisor. Nothing that the process sends is trusted. Destruction
/// kills the process and all that it has started.
class RunProcess
{
public:
    using Clock = std::chrono::steady_clock;

    /// Starts the run.
    /// \param index passed through
    /// \param slot passed through
    /// \param cpus that the run keeps to; none: any
    /// \throws std::system_error if the system has no process or pipe left.
    RunProcess(const RunSpec &spec, std::size_t index, std::size_t slot, const CpuList &cpus);
    ~RunProcess();
    RunProcess(const RunProcess &) = delete;
    RunProcess &operator=(const RunProcess &) = delete;

    std::size_t index() const { return index_; }
    std::size_t slot() const { return slot_; }
    pid_t pid() const { return pid_; }
    /// Descriptors to wait on for input; -1 once closed.
    int resultPipe() const { return result_; }
    int outputPipe() const { return output_; }
    /// When to call enforceDeadline() next.
    Clock::time_point deadline() const { return deadline_; }

    /// Takes what the process has sent so far, without waiting.
    void readAll();
    /// Kills the process group if its stage has lasted too long: solving, if it has used its time limit of CPU time,
    /// and the grace, or much more wall time.
    void enforceDeadline(Clock::time_point now);
    /// True once the process has ended; then what it left behind is gone, too, and all that it sent has been read.
    bool hasEnded();
    /// Has somebody else killed it, such as a system out of memory, or has it killed itself? Only after hasEnded().
    bool wasKilledFromOutside() const;
    /// How the run ended. Only after hasEnded().
    Record record() const;

private:
    enum class Stop
    {
        None,
        Overdue,   ///< the stage took too long
        Oversized  ///< more result than a result can be
    };

    void enter(RunStage stage);
    /// When a solving process may be over its limit of CPU time, of which it has used so much.
    Clock::time_point nextLook(double cpuUsed) const;
    void kill(Stop why);
    void readResult();
    void readOutput();
    void takeMarks();
    Record fromEnd() const;
    Record fromKill() const;

    const RunSpec &spec_;
    std::size_t index_;
    std::size_t slot_;
    pid_t pid_ = -1;
    int result_ = -1;
    int output_ = -1;
    int waitStatus_ = 0;
    RunStage stage_ = RunStage::Building;
    Clock::time_point stageStart_;
    double stageStartCpu_ = 0.0;
    Clock::time_point lastMoment_;  ///< of the stage, whatever CPU time it gets
    Clock::time_point deadline_;
    Stop stop_ = Stop::None;
    double stageSeconds_ = 0.0;  ///< how long the stage had lasted when the process was killed
    double stageCpuSeconds_ = 0.0;
    bool resultBegun_ = false;  ///< all marks have been read
    std::string resultText_;    ///< marks not yet taken, then the record
    std::string tail_;          ///< the last of stdout and stderr
};
}  // namespace narrows
