// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Metrics.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace narrows
{
namespace
{
template <typename Value>
Cell toCell(const Value &value)
{
    if constexpr (std::is_same_v<Value, std::string>)
        return value;
    else if constexpr (std::is_floating_point_v<Value>)
        return std::isfinite(value) ? Cell(value) : Cell();  // as OMPL's own importer does
    else
        return static_cast<std::int64_t>(value);
}

template <typename Value>
Cell toCell(const std::optional<Value> &value)
{
    return value ? toCell(*value) : Cell();
}

template <typename Value>
auto of(Value Record::*member)
{
    return [member](const RunSpec &, const Record &record)
    {
        return toCell(record.*member);
    };
}

template <typename Value>
auto of(Value RunSpec::*member)
{
    return [member](const RunSpec &spec, const Record &)
    {
        return toCell(spec.*member);
    };
}

template <typename Value>
auto jsonOf(Value Record::*member)
{
    return [member](const RunSpec &, const Record &record) -> Cell
    {
        return nlohmann::json(record.*member).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    };
}

Cell megabytes(const RunSpec &, const Record &record)
{
    return record.peakMemoryKb ? Cell(*record.peakMemoryKb / 1024.0) : Cell();
}

Cell segments(const RunSpec &, const Record &record)
{
    return record.waypoints ? Cell(*record.waypoints - 1) : Cell();
}

Cell solved(const RunSpec &, const Record &record)
{
    return toCell(record.outcome == Outcome::Solved);
}

Cell approximate(const RunSpec &, const Record &record)
{
    return toCell(record.outcome == Outcome::Approximate);
}

Cell outcome(const RunSpec &, const Record &record)
{
    return toString(record.outcome);
}
}  // namespace

const std::vector<Metric> &metrics()
{
    static const std::vector<Metric> table{
        {"time", "REAL", "wall time of solve(), s", of(&Record::time)},
        {"memory", "REAL", "growth of the process's peak memory, MB", megabytes},
        {"status", "ENUM", "what the planner returned (OMPL's PlannerStatus)", of(&Record::status)},
        {"solved", "BOOLEAN", "an exact path, accepted by the verifier", solved},
        {"approximate_solution", "BOOLEAN", "the path does not reach the goal", approximate},
        {"solution_difference", "REAL", "how far an approximate path ends from the goal",
         of(&Record::solutionDifference)},
        {"solution_length", "REAL", "Euclidean length over the joints (planar arms: absolute angles), rad",
         of(&Record::length)},
        {"solution_smoothness", "REAL", "OMPL's measure of bends, 0 is straight", of(&Record::smoothness)},
        {"solution_clearance", "REAL", "least distance to an obstacle over the whole path (verifier), length",
         of(&Record::clearance)},
        {"solution_segments", "INTEGER", "waypoints less one", segments},
        {"correct_solution", "BOOLEAN", "the verifier's verdict on a path claimed exact", of(&Record::verified)},
        {"simplification_time", "REAL", "CPU time of OMPL's path simplification, s", of(&Record::simplificationTime)},
        {"simplified_solution_length", "REAL", "length after simplification, rad", of(&Record::simplifiedLength)},
        {"simplified_correct_solution", "BOOLEAN", "the verifier's verdict on the simplified path",
         of(&Record::simplifiedVerified)},
        {"graph_states", "INTEGER", "vertices of the planner's graph", of(&Record::graphStates)},
        {"graph_motions", "INTEGER", "edges of the planner's graph", of(&Record::graphMotions)},
        {"run", "INTEGER", "index of the run, from 0", of(&RunSpec::run)},
        {"seed", "INTEGER", "of this run: repeats it alone", of(&RunSpec::seed)},
        {"outcome", "TEXT", "how the run ended; only solved counts as solved", outcome},
        {"reason", "TEXT", "why, in the words of planner, verifier or system", of(&Record::reason)},
        {"verified", "BOOLEAN", "the same as correct_solution, under the name of the JSON records",
         of(&Record::verified)},
        {"cpu_time", "REAL", "CPU time of solve(), all threads, s", of(&Record::cpuTime)},
        {"state_checks", "INTEGER", "states the planner asked about", of(&Record::stateChecks)},
        {"motion_checks", "INTEGER", "motions the planner asked about", of(&Record::motionChecks)},
        {"evaluations", "INTEGER", "configurations examined for either, plus evaluations of a homotopy",
         of(&Record::evaluations)},
        {"peak_memory_kb", "REAL", "growth of the process's peak memory, KB", of(&Record::peakMemoryKb)},
        {"cpus", "TEXT", "CPUs that the run was kept to; NULL: it was not pinned", of(&Record::cpus)},
        {"shares_core", "BOOLEAN", "another run may have been on the same physical core", of(&Record::sharesCore)},
        {"waypoints", "INTEGER", "states of the path", of(&Record::waypoints)},
        {"max_joint_step", "REAL", "largest change of one joint between two waypoints, rad", of(&Record::maxJointStep)},
        {"largest_bend", "REAL", "largest bend of a universal joint over the path, rad", of(&Record::largestBend)},
        {"moved_joints", "INTEGER", "turning joints that leave their start value; arms in space",
         of(&Record::movedJoints)},
        {"tip_length", "REAL", "length of the tip's way; arms in space", of(&Record::tipLength)},
        {"tip_deviation", "REAL", "largest distance of the tip from the tip path, between waypoints too, length",
         of(&Record::tipDeviation)},
        {"closure", "REAL", "largest joint change from start to end of a closed tip path, rad", of(&Record::closure)},
        {"duration", "REAL", "of the fastest proven motion found along the path under the limits, s",
         of(&Record::duration)},
        {"stop_duration", "REAL", "of the fastest motion that stops at the path's corners, s",
         of(&Record::stopDuration)},
        {"peak_velocity", "REAL", "of that fastest motion, over all joints, rad/s", of(&Record::peakVelocity)},
        {"peak_acceleration", "REAL", "likewise, rad/s^2", of(&Record::peakAcceleration)},
        {"peak_jerk", "REAL", "likewise, rad/s^3", of(&Record::peakJerk)},
        {"prescribed", "BOOLEAN", "used the scenario's recipe: knowledge other planners do not get",
         of(&Record::prescribed)},
        {"uses_model", "BOOLEAN", "sees robot and obstacles, not only whether states are free", of(&Record::usesModel)},
        {"parameters", "TEXT", "all of the planner's parameters as used, JSON", jsonOf(&Record::parameters)},
        {"measures", "TEXT", "the planner's own measures, JSON", jsonOf(&Record::measures)},
        {"recipe", "TEXT", "parameters that follow the same curve again, JSON", jsonOf(&Record::recipe)},
        {"output", "TEXT", "last lines the run wrote to stdout and stderr", of(&Record::output)}};
    return table;
}

bool isMeasured(const Metric &metric)
{
    for (const char *name :
         {"time", "cpu_time", "simplification_time", "memory", "peak_memory_kb", "cpus", "shares_core"})
        if (metric.name == name)
            return true;
    return false;
}
}  // namespace narrows
