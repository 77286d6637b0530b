// SPDX-License-Identifier: BSD-3-Clause
// One planner, one scenario, from a program of one's own (docs/tutorials.md):
//
//   10_first_plan PLANNER SCENARIO.yaml
#include <iostream>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/ModelPlanner.h"
#include "scenario/Problem.h"

namespace
{
int plan(const std::string &name, const std::string &file)
{
    const narrows::Scenario scenario = narrows::readScenario(file);
    const narrows::Problem problem = narrows::makeProblem(scenario);
    const auto planner = narrows::makePlanner(name, problem.context);
    planner->setProblemDefinition(problem.pdef);
    const ompl::base::PlannerStatus status = planner->solve(10.0);
    if (const auto *ours = dynamic_cast<const narrows::ModelPlanner *>(planner.get()))
        for (const auto &[measure, value] : ours->measures())
            std::cout << measure << ' ' << value << '\n';
    if (status != ompl::base::PlannerStatus::EXACT_SOLUTION)
    {
        std::cout << name << ": " << status.asString() << '\n';
        return 1;
    }
    const auto &path = *problem.pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
    const narrows::Verdict verdict = narrows::verify(scenario.world, problem.space->unwrap(path));
    std::cout << name << ": " << path.getStateCount() << " states, "
              << (verdict.accepted ? "proven free" : verdict.reason) << ", clearance " << verdict.clearance << '\n';
    return verdict.accepted ? 0 : 1;
}
}  // namespace

int main(int argc, char **argv)
try
{
    if (argc != 3)
    {
        std::cerr << "usage: 10_first_plan PLANNER SCENARIO.yaml\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ompl::RNG::setSeed(1);
    return plan(argv[1], argv[2]);
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 1;
}
