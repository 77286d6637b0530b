// SPDX-License-Identifier: BSD-3-Clause
// A pipe moves while a hyper-redundant manipulator leads its tip to a place (the outlook of VDSM: moving obstacles).
// Ten times a second the arm plans anew: from the stretched arm to where the tip can be after the tick, past the pipe
// as large as all the places that it can have until then. The pose in which that plan ends is where the arm goes, in
// one motion; a taut string that the pipe pushes makes the arm give way.
//
//   03_moving_pipe SCENARIO.yaml VY VZ [REPORT]
//
// The scenario starts stretched along x, its goal is a tip, its first obstacle a cylinder along x, which moves with
// (VY, VZ) per second. REPORT is "all" for a line per tick.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/util/Console.h>

#include "planners/ModelPlanner.h"
#include "scenario/Problem.h"

namespace
{
namespace ob = ompl::base;
using Path = std::vector<Eigen::VectorXd>;

constexpr double tick = 0.1;        // seconds
constexpr double tipSpeed = 300.0;  // per second
constexpr int mostTicks = 400;
constexpr double tipRoom = 1.8;  // between tip and pipe, in radii of the arm

narrows::Cylinder &pipeOf(narrows::SpatialModel &model)
{
    return std::get<narrows::Cylinder>(model.obstacles.front().shape);
}

/// What the tip keeps from the pipe's axis.
double roomOf(narrows::SpatialModel &model)
{
    return pipeOf(model).radius + tipRoom * model.arm.links().back().radius;
}

/// The scenario from a time on until the next tick: the pipe as large as all of its places.
narrows::Scenario during(const narrows::Scenario &scenario, double time, const Eigen::Vector3d &velocity)
{
    narrows::Scenario now = scenario;
    narrows::SpatialModel model = *now.spatial().model;
    narrows::Cylinder &pipe = pipeOf(model);
    pipe.center += velocity * (time + tick / 2.0);
    pipe.radius += velocity.norm() * tick / 2.0;
    now.spatial().model = std::make_shared<narrows::SpatialModel>(std::move(model));
    return now;
}

/// Seen along x, where the arm passes the pipe: beside the pipe's centre, in the direction of the nearest link, as far
/// off as the tip keeps.
Eigen::Vector3d besideThePipe(const narrows::Scenario &now, const Eigen::VectorXd &q, double x)
{
    narrows::SpatialModel model = *now.spatial().model;
    const narrows::Cylinder &pipe = pipeOf(model);
    const Eigen::Vector2d center = pipe.center.tail<2>();
    narrows::SpatialArm::Placement placement;
    model.arm.place(q, placement);
    Eigen::Vector2d nearest = placement.points.front().tail<2>() - center;
    for (std::size_t i = 0; i < placement.points.size(); i += 2)
    {
        const Eigen::Vector2d from = placement.points[i].tail<2>() - center;
        const Eigen::Vector2d along = placement.points[i + 1].tail<2>() - center - from;
        const double share = std::clamp(-from.dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
        if ((from + share * along).norm() < nearest.norm())
            nearest = from + share * along;
    }
    const Eigen::Vector2d place = center + roomOf(model) * nearest.normalized();
    return {x, place.x(), place.y()};
}

Eigen::Vector3d tipOf(const narrows::SpatialArm &arm, const Eigen::VectorXd &q)
{
    narrows::SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement.points.back();
}

/// Where the tip shall be after a tick: a step nearer to the goal, but not near the pipe.
Eigen::Vector3d nextTip(const narrows::Scenario &now, const Eigen::Vector3d &tip, const Eigen::Vector3d &goal)
{
    const Eigen::Vector3d way = goal - tip;
    Eigen::Vector3d next = tip + way * std::min(1.0, tipSpeed * tick / std::max(way.norm(), 1e-9));
    narrows::SpatialModel model = *now.spatial().model;
    const narrows::Cylinder &pipe = pipeOf(model);
    const double room = roomOf(model);
    const Eigen::Vector2d away = next.tail<2>() - pipe.center.tail<2>();
    if (away.norm() < room)
        next.tail<2>() = pipe.center.tail<2>() + room * away.normalized();
    return next;
}

/// The pose in which a plan to a place of the tip ends; nothing, and why, if there is no plan.
struct Pose
{
    std::optional<Eigen::VectorXd> q;
    std::string reason;
};

/// \param tips places that the tip is led to, one after the other
Pose poseFor(narrows::Scenario now, const std::vector<Eigen::Vector3d> &tips)
{
    const auto goal = std::get<narrows::SpatialTipGoal>(now.spatial().task.goal);
    if (tips.size() == 1)
        now.spatial().task.goal = narrows::SpatialTipGoal{goal.link, tips.front(), goal.tolerance};
    else
        now.spatial().task.goal = narrows::SpatialTipPath{goal.link, tips, goal.tolerance};
    const narrows::Problem problem = narrows::makeProblem(now);
    const auto planner = narrows::makePlanner("vdsm", problem.context);
    planner->setProblemDefinition(problem.pdef);
    planner->setup();
    if (planner->solve(ob::timedPlannerTerminationCondition(tick)) != ob::PlannerStatus::EXACT_SOLUTION)
        return {std::nullopt, dynamic_cast<const narrows::ModelPlanner &>(*planner).reason()};
    return {problem.space->unwrap(*problem.pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>()).back(), ""};
}

/// Throws if the verifier refuses the motion. \return its clearance
double prove(narrows::Scenario now, const Eigen::VectorXd &from, const Eigen::VectorXd &to)
{
    now.spatial().task.start = from;
    now.spatial().task.goal = to;
    const narrows::Verdict verdict = narrows::verify(now.world, {from, to});
    if (!verdict.accepted)
        throw std::runtime_error("the verifier refuses a motion: " + verdict.reason);
    return verdict.clearance;
}

struct Report
{
    std::string end = "not there";
    int ticks = 0, moves = 0;
    double clearance = std::numeric_limits<double>::infinity();  ///< of all that was gone
    double slowest = 0.0;                                        ///< tick, milliseconds
};

Report run(const narrows::Scenario &scenario, const Eigen::Vector3d &velocity, bool all)
{
    const narrows::SpatialArm &arm = scenario.spatial().model->arm;
    const auto &goal = std::get<narrows::SpatialTipGoal>(scenario.spatial().task.goal);
    Eigen::VectorXd q = scenario.spatial().task.start;
    Report report;
    for (; report.ticks < mostTicks; ++report.ticks)
    {
        const Eigen::Vector3d tip = tipOf(arm, q);
        if ((tip - goal.point).norm() <= goal.tolerance)
        {
            report.end = "arrived";
            break;
        }
        const auto begin = std::chrono::steady_clock::now();
        const narrows::Scenario now = during(scenario, report.ticks * tick, velocity);
        const auto checker = narrows::makeArmChecker("analytic", now.world);
        if (!checker->isFree(q))
        {
            report.end = "the pipe reaches the arm";
            break;
        }
        const Eigen::Vector3d aim = nextTip(now, tip, goal.point);
        const auto canGo = [&](const Pose &pose)
        {
            std::uint64_t placements = 0;
            return pose.q && checker->isMotionFree(q, *pose.q - q, placements);
        };
        Pose pose = poseFor(now, {aim});
        if (!canGo(pose))
            pose = poseFor(now, {besideThePipe(now, q, aim.x()), aim});
        const bool goes = canGo(pose);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        report.slowest = std::max(report.slowest, time.count());
        const Eigen::VectorXd next = goes ? *pose.q : q;  // where it is, it is safe until the next tick
        report.clearance = std::min(report.clearance, prove(now, q, next));
        report.moves += goes ? 1 : 0;
        if (all)
            std::cout << fmt::format("{:.1f} s: tip {:.0f} {:.0f}, {}\n", report.ticks * tick, tip.y(), tip.z(),
                                     goes ? "goes" : "waits (" + (pose.q ? "motion" : pose.reason) + ")");
        q = next;
    }
    return report;
}
}  // namespace

int main(int count, char **arguments)
{
    if (count != 4 && count != 5)
    {
        std::cerr << "usage: 03_moving_pipe SCENARIO.yaml VY VZ [all]\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    try
    {
        const narrows::Scenario scenario = narrows::readScenario(arguments[1]);
        if (!std::holds_alternative<narrows::SpatialTipGoal>(scenario.spatial().task.goal))
            throw std::invalid_argument(scenario.name + ": the goal must be a tip");
        const auto &obstacles = scenario.spatial().model->obstacles;
        if (obstacles.empty() || !std::holds_alternative<narrows::Cylinder>(obstacles.front().shape))
            throw std::invalid_argument(scenario.name + ": the first obstacle must be a cylinder");
        const Report report = run(scenario, Eigen::Vector3d(0.0, std::stod(arguments[2]), std::stod(arguments[3])),
                                  count == 5 && std::string(arguments[4]) == "all");
        std::cout << fmt::format(
            "{} after {} ticks: {} motions, clearance {:.1f} proven, {:.2f} ms for the slowest tick\n", report.end,
            report.ticks, report.moves, report.clearance, report.slowest);
        return report.end == "arrived" ? 0 : 1;
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
