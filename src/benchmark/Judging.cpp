// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Judging.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <ompl/base/PlannerData.h>

#include "kernel/PathMeasures.h"
#include "planners/ModelPlanner.h"
#include "spaces/JointCoordinates.h"

namespace narrows
{
namespace
{
double lengthOf(const std::vector<Eigen::VectorXd> &rows)
{
    double length = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        length += (rows[i] - rows[i - 1]).norm();
    return length;
}

double maxJointStepOf(const std::vector<Eigen::VectorXd> &rows, const std::vector<ArmJoint> &joints)
{
    double step = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t joint = 0; joint < joints.size(); ++joint)
            if (joints[joint].turns)
                step = std::max(step, std::abs(rows[i][joint] - rows[i - 1][joint]));
    return step;
}

/// "collision: segment 3 at 0.25, link 1, obstacle C1"
std::string refusal(const Verdict &verdict)
{
    std::string text = verdict.reason;
    if (verdict.segment >= 0)
        text += fmt::format(": segment {} at {:.6g}", verdict.segment, verdict.fraction);
    if (verdict.link >= 0)
        text += fmt::format(", link {}", verdict.link);
    if (verdict.otherLink >= 0)
        text += fmt::format(", link {}", verdict.otherLink);
    if (!verdict.obstacle.empty())
        text += fmt::format(", obstacle {}", verdict.obstacle);
    if (verdict.tip >= 0)
        text += fmt::format(", tip {}", verdict.tip);
    return text;
}

void measureInSpace(const Scenario &scenario, const std::vector<Eigen::VectorXd> &rows, Record &record)
{
    if (scenario.isPlanar() || rows.empty())
        return;
    const SpatialWorld &world = scenario.spatial();
    const PathMeasures measures = measurePath(world.model->arm, world.task, rows);
    record.largestBend = measures.largestBend;
    record.movedJoints = measures.movedJoints;
    record.tipLength = measures.tipLength;
    record.tipDeviation = measures.tipDeviation;
    record.closure = measures.closure;
}

void judgeClaim(const RunSpec &spec, const Problem &problem, const og::PathGeometric *path, Record &record)
{
    record.outcome = Outcome::Unverified;
    record.verified = false;
    if (path == nullptr)
    {
        record.reason = "no_path";
        return;
    }
    const std::vector<Eigen::VectorXd> rows = problem.space->unwrap(*path);
    record.waypoints = static_cast<std::int64_t>(rows.size());
    record.length = lengthOf(rows);
    record.maxJointStep = maxJointStepOf(rows, problem.space->joints());
    if (rows.size() > 0)
        record.smoothness = path->smoothness();
    measureInSpace(*spec.scenario, rows, record);
    for (const Eigen::VectorXd &row : rows)
        record.path.push_back(toFile(spec.scenario->world, row));

    const Verdict verdict = verify(spec.scenario->world, rows);
    record.verified = verdict.accepted;
    if (verdict.accepted)
    {
        record.outcome = Outcome::Solved;
        record.clearance = verdict.clearance;
    }
    else
        record.reason = refusal(verdict);
}

void recordVias(const RunSpec &spec, const Problem &problem, const Eigen::MatrixXd &vias, Record &record)
{
    if (vias.size() == 0)
        return;
    const Eigen::MatrixXd configurations = JointCoordinates(*problem.space).toConfiguration() * vias;
    for (const auto &configuration : configurations.colwise())
        record.vias.push_back(toFile(spec.scenario->world, Eigen::VectorXd(configuration)));
}

/// The outcome of a solve() that claims no exact solution.
Outcome outcomeOf(const SolveMeasurement &measurement)
{
    const ob::PlannerStatus::StatusType status = measurement.status;
    switch (status)
    {
        case ob::PlannerStatus::INVALID_START:
            return Outcome::InvalidStart;
        case ob::PlannerStatus::INVALID_GOAL:
            return Outcome::InvalidGoal;
        case ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE:
            return Outcome::Unsupported;
        default:
            break;
    }
    if (measurement.expired)
        return Outcome::Timeout;
    return status == ob::PlannerStatus::APPROXIMATE_SOLUTION ? Outcome::Approximate : Outcome::NoSolution;
}

/// One word for a solve() that ended early without a solution or refused the problem. OMPL 1.5.2 has no text for some.
std::string wordFor(const ob::PlannerStatus &status)
{
    switch (static_cast<ob::PlannerStatus::StatusType>(status))
    {
        case ob::PlannerStatus::TIMEOUT:
            return "gave_up";
        case ob::PlannerStatus::ABORT:
            return "abort";
        case ob::PlannerStatus::UNKNOWN:
            return "unknown_status";
        case ob::PlannerStatus::CRASH:
            return "crash_status";
        case ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE:
            return "goal_type";
        default:
            return status.asString();
    }
}
}  // namespace

void recordCosts(const SolveMeasurement &measurement, Record &record)
{
    record.time = measurement.time;
    record.cpuTime = measurement.cpuTime;
    record.stateChecks = static_cast<std::int64_t>(measurement.stateChecks);
    record.motionChecks = static_cast<std::int64_t>(measurement.motionChecks);
    record.evaluations = static_cast<std::int64_t>(measurement.placements);
}

std::int64_t homotopyEvaluations(const ob::Planner &planner)
{
    const auto *modelPlanner = dynamic_cast<const ModelPlanner *>(&planner);
    if (modelPlanner == nullptr)
        return 0;
    const auto own = modelPlanner->measures().find("homotopy_evaluations");
    return own == modelPlanner->measures().end() ? 0 : static_cast<std::int64_t>(own->second);
}

void judge(const RunSpec &spec, const Problem &problem, const ob::Planner &planner, const SolveMeasurement &measurement,
           const og::PathGeometric *path, Record &record)
{
    if (measurement.failure)
    {
        record.outcome = *measurement.failure;
        record.reason = measurement.failureText;
        return;
    }
    record.status = static_cast<int>(static_cast<ob::PlannerStatus::StatusType>(measurement.status));
    if (measurement.status == ob::PlannerStatus::EXACT_SOLUTION)
    {
        judgeClaim(spec, problem, path, record);
        return;
    }
    record.outcome = outcomeOf(measurement);
    const auto *modelPlanner = dynamic_cast<const ModelPlanner *>(&planner);
    record.reason = modelPlanner != nullptr ? modelPlanner->reason() : std::string();
    if (record.reason.empty() && (record.outcome == Outcome::NoSolution || record.outcome == Outcome::Unsupported))
        record.reason = wordFor(measurement.status);
    if (measurement.status == ob::PlannerStatus::APPROXIMATE_SOLUTION)
        record.solutionDifference = problem.pdef->getSolutionDifference();
}

void judgeSimplified(const RunSpec &spec, const Problem &problem, const og::PathGeometric &path, Record &record)
{
    const std::vector<Eigen::VectorXd> rows = problem.space->unwrap(path);
    record.simplifiedLength = lengthOf(rows);
    record.simplifiedVerified = verify(spec.scenario->world, rows).accepted;
}

void recordPlannerData(const RunSpec &spec, const Problem &problem, const ob::Planner &planner, Record &record)
{
    if (const auto *modelPlanner = dynamic_cast<const ModelPlanner *>(&planner))
    {
        record.measures = modelPlanner->measures();
        record.recipe = modelPlanner->recipe();
        recordVias(spec, problem, modelPlanner->vias(), record);
        if (record.evaluations)
            *record.evaluations += homotopyEvaluations(planner);
    }
    try
    {
        ob::PlannerData data(problem.si);
        planner.getPlannerData(data);
        record.graphStates = data.numVertices();
        record.graphMotions = data.numEdges();
    }
    catch (...)
    {
        // A planner that cannot show its graph has still planned; the sizes stay empty.
        record.graphStates.reset();
        record.graphMotions.reset();
    }
}

std::shared_ptr<og::PathGeometric> copySolution(const ob::ProblemDefinition &pdef)
{
    const auto path = std::dynamic_pointer_cast<og::PathGeometric>(pdef.getSolutionPath());
    return path ? std::make_shared<og::PathGeometric>(*path) : nullptr;
}
}  // namespace narrows
