// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/HomotopyCurve.h"

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
    StepUnderflow,    ///< no step was small enough; see Trace::lastRejection
    InvalidStart,     ///< the start lies on a pole or beyond one
    Singular,         ///< the curve has no direction
    MaxSteps,
    Interrupted
};

/// "reached_goal", "wrong_root", ...
std::string toString(TraceStatus status);

/// What keeps a step from being longer.
enum class StepLimit
{
    Longest,      ///< TrackerOptions::maxStep; never rejects
    Growth,       ///< not too much longer than the step before; never rejects
    Correction,   ///< the prediction lies far from the curve
    Contraction,  ///< the corrections do not shrink fast enough
    Turn,         ///< the tangent turns too far: also what a jump to the next branch looks like
    Determinant,  ///< the augmented determinant changes too much
    Pole,         ///< an obstacle function falls too far
    Guard         ///< TrackerOptions::guard refuses the straight way
};
constexpr int stepLimitCount = 8;  ///< values of StepLimit

/// "longest", "growth", ...
std::string toString(StepLimit limit);

/// One step that the adaptive tracker tried.
struct TraceStep
{
    Eigen::VectorXd z;  ///< where it led: a point of the curve if accepted, the last correction if not
    double length;      ///< in the metric of z
    bool accepted;      ///< whether it became part of the curve
    StepLimit limit;    ///< accepted: what set the length; rejected: what refused it
    int corrections;    ///< Newton's updates
};

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

/// A curve that was followed, and what that cost.
struct Trace
{
    TraceStatus status = TraceStatus::Interrupted;  ///< how it ended
    std::vector<Eigen::VectorXd> configurations;    ///< first the start; last the goal itself if it was reached
    std::vector<double> lambdas;                    ///< one per configuration
    int steps = 0;                                  ///< accepted; for the full form, the paper's number of hyperspheres
    int rejected = 0;                               ///< steps that were tried and given up
    std::int64_t evaluations = 0;                   ///< of the homotopy
    int wrongRoots = 0;                             ///< crossings of lambda = 1 elsewhere than in the goal

    // Of the adaptive tracker only:
    int folds = 0;                                 ///< how often the curve turned round in lambda
    std::array<int, stepLimitCount> limitedBy{};   ///< accepted steps by what set their length
    std::array<int, stepLimitCount> rejectedBy{};  ///< rejected steps by what refused them
    std::optional<StepLimit> lastRejection;        ///< none if no step was refused
    int lastPole = -1;                             ///< index of the pole that last refused a step (CurvePoint::poles)
    std::vector<TraceStep> log;                    ///< every step that was tried, if TrackerOptions::log
};

/// How a curve has ended that is at this lambda and this far from its start; nothing while it is within the window.
std::optional<TraceStatus> departure(const TraceWindow &window, double lambda, double deviation, int wrongRoots);

/// True, with a trace of one point, if the goal is the start.
bool standsStill(const HomotopyCurve &curve, Trace &trace);

}  // namespace narrows
