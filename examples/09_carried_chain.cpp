// SPDX-License-Identifier: BSD-3-Clause
// A mobile robot carries a chain to its entrance, through obstacles that rest and that move; then the chain is fed in
// (tight maneuvering, Fig. 15). The carriage is planned and certified in space and time, the feeding by the planner
// tight. While it is fed, what has not passed the entrance yet lies where the carried chain lay when it arrived: the
// certificate of the carriage, which goes on for ever, holds for that part too.
//
//   09_carried_chain SCENARIO.yaml        (of a planar chain on a slide, such as tight_ladder.yaml)
//
// Two discs cross before the entrance, one to the left, one to the right; a third stands in the way and leaves when
// they have passed.
#include <exception>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/util/Console.h>

#include "kernel/chain/Carriage.h"
#include "planners/ModelPlanner.h"
#include "scenario/Problem.h"

namespace
{
using Eigen::Vector2d;

/// The chain as it lies on the robot, whose place is the tip, and where it is to be fed.
struct Dock
{
    Vector2d tip;
    double heading;
    double length;
    double radius;
};

Dock dockOf(const narrows::Scenario &scenario)
{
    const narrows::PlanarArm &arm = scenario.planar().model->arm;
    std::vector<Vector2d> centres;
    arm.place(scenario.planar().task.start, centres);
    const Vector2d along = centres.back() - centres.front();
    return {centres.back(), std::atan2(along.y(), along.x()), along.norm(), arm.radius()};
}

std::vector<narrows::MovingDisc> discsOf(const Dock &dock)
{
    const double l = dock.length;
    const Vector2d along(std::cos(dock.heading), std::sin(dock.heading)), left(-along.y(), along.x());
    const auto place = [&](double before, double aside)
    {
        return Vector2d(dock.tip - before * l * along + aside * l * left);
    };
    return {{0.05 * l, {0.0, 20.0}, {place(0.4, -1.5), place(0.4, 1.5)}},
            {0.05 * l, {0.0, 20.0}, {place(0.9, 1.5), place(0.9, -1.5)}},
            {0.05 * l, {20.0, 25.0}, {place(0.2, 0.0), place(0.2, 1.5)}}};
}

narrows::CarriagePlan carry(const narrows::Scenario &scenario, const Dock &dock,
                            const std::vector<narrows::MovingDisc> &discs, const narrows::Carrier &carrier)
{
    const narrows::ChordObstacles<2> resting(scenario.planar().model->obstacles);
    narrows::CarriageOptions options{};
    options.lower = dock.tip - Vector2d::Constant(1.8 * dock.length);
    options.upper = dock.tip + Vector2d::Constant(1.8 * dock.length);
    options.spacing = 0.1 * dock.length;
    options.speed = 0.1 * std::sqrt(2.0) * dock.length;  // a tick is a second
    options.turnRate = 0.4;
    const Vector2d along(std::cos(dock.heading), std::sin(dock.heading)), left(-along.y(), along.x());
    const narrows::CarrierPose start{0.0, dock.tip - 1.2 * dock.length * along + 0.6 * dock.length * left,
                                     dock.heading + 0.5 * M_PI};
    const narrows::CarriagePlan plan = planCarriage(start, dock.tip, dock.heading, carrier, resting, discs, options);
    if (plan.failure != narrows::CarriageFailure::None)
        throw std::runtime_error("the carriage: " + toText(plan.failure));
    const narrows::CarriageVerdict verdict = certifyCarriage(plan.way, carrier, resting, discs);
    if (!verdict)
        throw std::runtime_error(fmt::format("the carriage touches obstacle {} at {}", verdict.obstacle, verdict.time));
    std::cout << fmt::format("carried in {:g} s and {} motions, clearance {:.3g} proven, {} states looked at\n",
                             plan.way.back().time, plan.way.size() - 1, verdict.clearance, plan.states);
    return plan;
}

void feed(const narrows::Scenario &scenario)
{
    const narrows::Problem problem = narrows::makeProblem(scenario);
    const auto planner = narrows::makePlanner("tight", problem.context);
    planner->setProblemDefinition(problem.pdef);
    planner->setup();
    if (planner->solve(ompl::base::timedPlannerTerminationCondition(20.0)) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        throw std::runtime_error("the feeding: " + dynamic_cast<const narrows::ModelPlanner &>(*planner).reason());
    const auto path = problem.space->unwrap(*problem.pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>());
    const narrows::Verdict verdict = narrows::verify(scenario.world, path);
    if (!verdict.accepted)
        throw std::runtime_error("the verifier refuses the feeding: " + verdict.reason);
    std::cout << fmt::format("fed in by {} motions, accepted by the verifier\n", path.size() - 1);
}
}  // namespace

int main(int count, char **arguments)
{
    if (count != 2)
    {
        std::cerr << "usage: 09_carried_chain SCENARIO.yaml\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    try
    {
        const narrows::Scenario scenario = narrows::readScenario(arguments[1]);
        if (!std::holds_alternative<narrows::PlanarWorld>(scenario.world))
            throw std::invalid_argument(scenario.name + ": the chain must be a planar one");
        const Dock dock = dockOf(scenario);
        carry(scenario, dock, discsOf(dock), {dock.length, 0.0, dock.radius});
        feed(scenario);
        return 0;
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
