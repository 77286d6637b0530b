// SPDX-License-Identifier: BSD-3-Clause
// The demonstration of HPPM-PRA's Section 6: a robot like the CRS CataLyst-5 goes to one goal and on to the next, past
// foam balls, along a homotopy curve per leg. The joint trajectory goes to a file, for whoever drives the robot.
//
//   01_crs_trajectory LEG.yaml... OUTPUT.csv
//
// Each leg begins where the one before ends.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/util/Console.h>

#include "planners/ModelPlanner.h"
#include "scenario/Problem.h"

namespace
{
using Path = std::vector<Eigen::VectorXd>;

struct Leg
{
    narrows::Scenario scenario;
    Path path;  ///< absolute angles, unwrapped
    int steps;  ///< of the curve; hyperspheres in the paper's form
    double milliseconds;
    double clearance;  ///< proven by the verifier
};

/// Follows the curve that the scenario prescribes. The time is the median over repetitions: the paper's robot, too, had
/// its program in memory.
Leg planLeg(const narrows::Scenario &scenario, const std::string &form)
{
    std::map<std::string, std::string> parameters = scenario.methods.at("hppm");
    parameters["search"] = "paper";
    parameters["form"] = form;
    const narrows::Problem problem = narrows::makeProblem(scenario);
    const auto planner = narrows::makePlanner("hppm", problem.context, parameters);
    planner->setProblemDefinition(problem.pdef);
    planner->setup();

    std::vector<double> times(101);
    for (double &time : times)
    {
        planner->clear();
        problem.pdef->clearSolutionPaths();
        const auto begin = std::chrono::steady_clock::now();
        planner->solve(ompl::base::plannerNonTerminatingCondition());
        time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    }
    std::nth_element(times.begin(), times.begin() + 50, times.end());

    const auto &hppm = dynamic_cast<const narrows::ModelPlanner &>(*planner);
    if (!problem.pdef->hasExactSolution())
        throw std::runtime_error(scenario.name + ": " + hppm.reason());
    const auto &solution = *problem.pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
    Leg leg{scenario, problem.space->unwrap(solution), 0, times[50], 0.0};
    leg.steps = static_cast<int>(hppm.measures().at(form == "full" ? "hyperspheres" : "steps"));
    const narrows::Verdict verdict = narrows::verify(scenario.world, leg.path);
    if (!verdict.accepted)
        throw std::runtime_error(scenario.name + ": the verifier refuses the path: " + verdict.reason);
    leg.clearance = verdict.clearance;
    return leg;
}

/// All legs in one form. \throws std::runtime_error if a leg fails or does not begin where the last one ended
std::vector<Leg> planLegs(const std::vector<narrows::Scenario> &scenarios, const std::string &form)
{
    std::vector<Leg> legs;
    for (const narrows::Scenario &scenario : scenarios)
    {
        legs.push_back(planLeg(scenario, form));
        if (legs.size() > 1 && (legs.back().path.front() - legs[legs.size() - 2].path.back()).norm() > 1e-9)
            throw std::runtime_error(scenario.name + " does not begin where the leg before ends");
    }
    return legs;
}

void report(const std::vector<Leg> &legs, const std::string &form)
{
    double milliseconds = 0.0;
    std::size_t numbers = 0;
    for (const Leg &leg : legs)
    {
        std::cout << fmt::format("{} {}: {} {}, {} waypoints, {:.3f} ms, clearance {:.4f}\n", leg.scenario.name, form,
                                 leg.steps, form == "full" ? "hyperspheres" : "steps", leg.path.size(),
                                 leg.milliseconds, leg.clearance);
        milliseconds += leg.milliseconds;
        numbers += leg.path.size() * static_cast<std::size_t>(leg.path.front().size());
    }
    std::cout << fmt::format(
        "all legs {}: {:.3f} ms (paper: 2 ms), trajectory of {:.3f} KB (paper's memory: 0.924 KB)\n", form,
        milliseconds, static_cast<double>(numbers * sizeof(double)) / 1e3);
}

/// One row per waypoint, the one that two legs share but once: degrees against the x axis, and against the link before.
void write(const std::vector<Leg> &legs, const std::string &file)
{
    std::ofstream out(file);
    const narrows::PlanarArm &arm = legs.front().scenario.planar().model->arm;
    out << "leg,waypoint";
    for (const char *kind : {"absolute", "relative"})
        for (int joint = 1; joint <= arm.dimension(); ++joint)
            out << fmt::format(",{}_{}_deg", kind, joint);
    out << '\n';
    constexpr double degree = 3.14159265358979323846 / 180.0;
    for (std::size_t leg = 0; leg < legs.size(); ++leg)
        for (std::size_t i = leg == 0 ? 0 : 1; i < legs[leg].path.size(); ++i)
        {
            const Eigen::VectorXd &absolute = legs[leg].path[i];
            const Eigen::VectorXd relative = arm.fromAbsolute(absolute, narrows::AngleConvention::Relative);
            out << leg + 1 << ',' << i;
            for (const Eigen::VectorXd *angles : {&absolute, &relative})
                for (const double angle : *angles)
                    out << fmt::format(",{:.6f}", angle / degree);
            out << '\n';
        }
    if (!out.flush())
        throw std::runtime_error(file + " cannot be written");
}
}  // namespace

int main(int count, char **arguments)
{
    if (count < 3)
    {
        std::cerr << "usage: 01_crs_trajectory LEG.yaml... OUTPUT.csv\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    try
    {
        std::vector<narrows::Scenario> scenarios;
        for (int i = 1; i + 1 < count; ++i)
            scenarios.push_back(narrows::readScenario(arguments[i]));
        const std::vector<Leg> full = planLegs(scenarios, "full");
        report(full, "full");
        report(planLegs(scenarios, "plane"), "plane");
        write(full, arguments[count - 1]);
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
