// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// How following a homotopy curve ended. Every way to stop has its own name.
enum class TraceStatus
{
    ReachedGoal,      ///< at lambda = 1, in the goal
    WrongRoot,        ///< lambda = 1 was reached only in other solutions than the goal
    TurnedBack,       ///< lambda fell below the window
    Escaped,          ///< lambda or a joint left the window on the other side
    ClosedLoop,       ///< the curve came back to its start
    CorrectorFailed,  ///< a sphere of fixed radius on which the corrector finds no point
    StepUnderflow,    ///< no step was small enough
    Singular,         ///< the curve has no direction
    MaxSteps,
    Interrupted
};

/// "reached_goal", "wrong_root", ...
std::string toString(TraceStatus status);

/// Where on the way from start to goal a curve may go. Outside the paper: it follows the curve until lambda = 1.
struct TraceWindow
{
    double lambdaMin = -0.1;      ///< below it the curve has turned back; < 0
    double lambdaMax = 1.0;       ///< 1: stop at the first lambda = 1, as printed; larger: go on from wrong roots
    double maxDeviation = 40.0;   ///< radians (slide: length), Euclidean; a curve this far from start has escaped
    bool decreasing = false;      ///< leave the start towards smaller lambda
    double goalTolerance = 1e-4;  ///< Euclidean distance; how near to the goal a root at lambda = 1 counts as the goal
};

/// \throws std::invalid_argument if a limit of the window is out of range.
void checkWindow(const TraceWindow &window);

struct Trace
{
    TraceStatus status = TraceStatus::Interrupted;
    std::vector<Eigen::VectorXd> configurations;  ///< first the start; last the goal itself if it was reached
    std::vector<double> lambdas;                  ///< one per configuration
    int steps = 0;                                ///< accepted; for the full form, the paper's number of hyperspheres
    int rejected = 0;                             ///< steps that were tried and given up
    std::int64_t evaluations = 0;                 ///< of W
    int wrongRoots = 0;                           ///< crossings of lambda = 1 elsewhere than in the goal
};

/// How a curve has ended that is at this lambda and this far from its start; nothing while it is within the window.
std::optional<TraceStatus> departure(const TraceWindow &window, double lambda, double deviation, int wrongRoots);

/// The trace of a task whose goal is its start.
Trace standStill(const Eigen::VectorXd &start);
}  // namespace narrows
