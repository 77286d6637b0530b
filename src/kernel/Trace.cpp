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
        case TraceStatus::InvalidStart:
            return "invalid_start";
        case TraceStatus::Singular:
            return "singular";
        case TraceStatus::MaxSteps:
            return "max_steps";
        case TraceStatus::Interrupted:
            return "interrupted";
    }
    throw std::logic_error("a trace status without a name");
}

std::string toString(StepLimit limit)
{
    switch (limit)
    {
        case StepLimit::Longest:
            return "longest";
        case StepLimit::Growth:
            return "growth";
        case StepLimit::Correction:
            return "correction";
        case StepLimit::Contraction:
            return "contraction";
        case StepLimit::Turn:
            return "turn";
        case StepLimit::Determinant:
            return "determinant";
        case StepLimit::Pole:
            return "pole";
        case StepLimit::Guard:
            return "guard";
    }
    throw std::logic_error("a step limit without a name");
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

bool standsStill(const HomotopyCurve &curve, Trace &trace)
{
    Eigen::VectorXd start, goal;
    curve.configuration(curve.startPoint(), start);
    curve.configuration(curve.goalPoint(), goal);
    if (start != goal)
        return false;
    trace.status = TraceStatus::ReachedGoal;
    trace.configurations.push_back(start);
    trace.lambdas.push_back(1.0);
    return true;
}
}  // namespace narrows
