// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/ViaPointIteration.h"

namespace narrows
{
namespace
{
/// T - log_n(distance |n^T - n^a|).
double logOf(double distance, double n, double a, double T)
{
    return T - std::log(distance * std::abs(std::pow(n, T) - std::pow(n, a))) / std::log(n);
}
}  // namespace

PaperLogs paperLogs(const ViaPointTask &task, const PaperParameters &parameters, double feedback)
{
    return {logOf(std::abs(feedback - task.start), parameters.nVia, parameters.aVia, task.viaTime),
            logOf(std::abs(task.goal - feedback), parameters.n, parameters.a, task.duration)};
}

IterationResult iterateFeedback(const ViaPointTask &task, const PaperParameters &parameters, double first, int maxSteps)
{
    const double n = parameters.n, t = task.viaTime;
    const double denominator = std::abs(std::pow(n, t + task.duration / t - 1.0) - std::pow(n, parameters.a));
    IterationResult result{first, 0, false};
    while (result.steps < maxSteps && !result.converged)
    {
        const double zeta = paperLogs(task, parameters, result.feedback).goalLog;
        const double term = std::pow(n, t - zeta) / denominator;
        const double next = result.feedback < task.goal ? task.via - term : task.via + term;
        ++result.steps;
        result.converged = next == result.feedback;
        result.feedback = next;
    }
    return result;
}
}  // namespace narrows
