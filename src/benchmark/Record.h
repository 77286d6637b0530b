// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "kernel/trajectory/MotionPeaks.h"
#include "scenario/Problem.h"

namespace narrows
{
/// How a run ended; every run ends in exactly one (design: only Solved counts as solved).
enum class Outcome
{
    Solved,       ///< exact, and the verifier accepts the path
    Unverified,   ///< claimed exact, refused by the verifier
    Approximate,  ///< the planner returned a path that does not reach the goal
    NoSolution,   ///< the planner gave up before the limit
    Timeout,
    Memory,
    Crash,  ///< signal or exception
    InvalidStart,
    InvalidGoal,
    Unsupported,   ///< this planner cannot do this problem
    InternalError  ///< our fault
};

/// "solved", "no_solution", ...
std::string toString(Outcome outcome);
/// \throws std::invalid_argument for a text that names no outcome.
Outcome outcomeFromString(const std::string &text);

/// One planned run: all that is needed to do it again, alone.
struct RunSpec
{
    std::string instance;  ///< one word, unique within a campaign: scenario, and what the sweep and checker make of it
    std::string group;     ///< the instance's name but for the seed of a sweep: what tables put together
    std::shared_ptr<const Scenario> scenario;
    ProblemOptions problem;
    std::string planner;                            ///< name in the factory
    std::string label;                              ///< how tables call this planner entry
    std::map<std::string, std::string> parameters;  ///< as the experiment gives them, over the scenario's recipe
    bool recipe = true;                             ///< may the planner use the scenario's `methods`?
    int run = 0;
    std::uint32_t seed = 1;
    double timeLimit = 10.0;             ///< seconds, for solve()
    double grace = 0.04;                 ///< seconds of CPU time after the time limit until the run is killed
    std::int64_t stateCheckLimit = 0;    ///< states that solve() may ask about; 0: any number
    std::int64_t evaluationLimit = 0;    ///< Record::evaluations that solve() may make; 0: any number
    double memoryLimit = 1024.0;         ///< MB on top of what the program needs before the run
    bool simplify = false;               ///< also time OMPL's path simplification
    std::optional<MotionLimits> limits;  ///< of every joint: also say how fast the path can be followed
    double warmUp = 0.0;  ///< seconds of untimed solving of the same problem beforehand, so that a fresh process's
                          ///< page faults and cold caches are not booked as planning
};

/// What a run left. Not measured is an empty optional (NULL, null), never 0.
struct Record
{
    Outcome outcome = Outcome::InternalError;
    std::string reason;  ///< the planner's own word, the exception's text, the signal's name, the verifier's reason
    std::optional<int> status;  ///< OMPL's PlannerStatus
    bool prescribed = false;    ///< the scenario's recipe was used: knowledge that other planners do not get
    bool usesModel = false;

    // Measured: may differ between two runs of the same spec.
    std::optional<double> time;                ///< wall seconds in solve()
    std::optional<double> cpuTime;             ///< CPU seconds of all threads in solve()
    std::optional<double> simplificationTime;  ///< CPU seconds
    std::optional<double>
        peakMemoryKb;                 ///< growth of the process's peak resident size since before the problem was built
    std::optional<std::string> cpus;  ///< that the run was kept to, as "0-3,8"; empty: not pinned
    std::optional<bool> sharesCore;   ///< may another run have been on the same physical core at the same time?

    // Everything below is the same for the same seed, for planners without threads.
    std::optional<std::int64_t> stateChecks;
    std::optional<std::int64_t> motionChecks;
    std::optional<std::int64_t> evaluations;  ///< configurations examined by the checker + homotopy evaluations of ours
    std::optional<std::int64_t> graphStates;
    std::optional<std::int64_t> graphMotions;
    std::optional<std::int64_t> waypoints;
    std::optional<double> length;              ///< Euclidean over configurations, radians
    std::optional<double> clearance;           ///< the verifier's, over the whole path
    std::optional<double> smoothness;          ///< OMPL's
    std::optional<double> solutionDifference;  ///< of an approximate solution
    std::optional<double> maxJointStep;        ///< largest change of one joint between two waypoints, radians
    std::optional<double> largestBend;         ///< of a universal joint, radians (these five: kernel/PathMeasures.h)
    std::optional<std::int64_t> movedJoints;   ///< turning joints that leave their start value
    std::optional<double> tipLength;           ///< of the tip's way
    std::optional<double> tipDeviation;        ///< of the tip from the tip path, between waypoints too
    std::optional<double> closure;             ///< largest joint change over a closed tip path, radians
    std::optional<double> simplifiedLength;
    std::optional<double> duration;      ///< of the fastest proven motion found under the limits, s (PathTiming.h)
    std::optional<double> stopDuration;  ///< of the fastest that stops at the path's corners, s
    std::optional<double> peakVelocity;  ///< over all joints, of the former: rad/s, rad/s^2, rad/s^3
    std::optional<double> peakAcceleration;
    std::optional<double> peakJerk;
    std::optional<bool> simplifiedVerified;
    std::optional<bool> verified;                   ///< empty if no exact path was claimed
    std::map<std::string, double> measures;         ///< the planner's own (hyperspheres, rejected_steps, ...)
    std::map<std::string, std::string> recipe;      ///< see ModelPlanner::recipe()
    std::map<std::string, std::string> parameters;  ///< all of the planner's parameters as they were used
    std::vector<Eigen::VectorXd> path;              ///< scenario's own convention, unwrapped; empty without a path
    std::vector<Eigen::VectorXd> vias;              ///< see ModelPlanner::vias(); as the path
    std::string output;                             ///< the last lines the run wrote to stdout and stderr
};

/// One JSON object with the keys of `narrows plan --json` (README), used for the terminal, the pipe and the store.
/// Not measured is null; JSON lacks infinity and NaN, which are written as the texts "inf", "-inf" and "nan".
std::string toJson(const RunSpec &spec, const Record &record);
/// The inverse of toJson, as far as the record goes.
/// \throws std::invalid_argument for text that toJson did not write.
Record recordFromJson(const std::string &text);
}  // namespace narrows
