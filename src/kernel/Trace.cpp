// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/Trace.h"

#include <stdexcept>

namespace narrows
{
std::string toString(TraceStatus status)
{
    switch (status)
    {
        case TraceStatus::ReachedGoal:
            return "reached_goal";
        case TraceStatus::WrongRoot:
            return "wrong_root";
        case TraceStatus::TurnedBack:
            return "turned_back";
        case TraceStatus::Escaped:
            return "escaped";
        case TraceStatus::ClosedLoop:
            return "closed_loop";
        case TraceStatus::CorrectorFailed:
            return "corrector_failed";
        case TraceStatus::StepUnderflow:
            return "step_underflow";
        case TraceStatus::Singular:
            return "singular";
        case TraceStatus::MaxSteps:
            return "max_steps";
        case TraceStatus::Interrupted:
            return "interrupted";
    }
    throw std::logic_error("a trace status without a name");
}

void checkWindow(const TraceWindow &window)
{
    if (!(window.lambdaMin < 0.0) || !(window.lambdaMax >= 1.0))
        throw std::invalid_argument("the window of lambda must reach from below 0 to at least 1");
    if (!(window.maxDeviation > 0.0) || !(window.goalTolerance > 0.0))
        throw std::invalid_argument("the largest deviation and the goal tolerance must be positive");
}

std::optional<TraceStatus> departure(const TraceWindow &window, double lambda, double deviation, int wrongRoots)
{
    if (lambda < window.lambdaMin)
        return TraceStatus::TurnedBack;
    if (lambda > window.lambdaMax)
        return wrongRoots > 0 ? TraceStatus::WrongRoot : TraceStatus::Escaped;
    if (deviation > window.maxDeviation)
        return TraceStatus::Escaped;
    return std::nullopt;
}

Trace standStill(const Eigen::VectorXd &start)
{
    Trace trace;
    trace.status = TraceStatus::ReachedGoal;
    trace.configurations.push_back(start);
    trace.lambdas.push_back(1.0);
    return trace;
}
}  // namespace narrows
