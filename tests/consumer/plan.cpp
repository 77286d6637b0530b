// SPDX-License-Identifier: BSD-3-Clause
// Three lines plan a scenario's way; the rest prints it.
#include <iostream>

#include <ompl/util/Console.h>

#include "scenario/Problem.h"

int main(int, char **argv)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const narrows::Problem problem = narrows::makeProblem(narrows::readScenario(argv[1]));
    const ompl::base::PlannerPtr planner = narrows::makePlanner(argv[2], problem.context);
    planner->setProblemDefinition(problem.pdef);
    const ompl::base::PlannerStatus status = planner->solve(10.0);
    std::cout << argv[2] << ": " << status.asString() << '\n';
    return status == ompl::base::PlannerStatus::EXACT_SOLUTION ? 0 : 1;
}
