// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/PlannerFactory.h"
#include "scenario/Problem.h"

namespace narrows
{
/// A planner of ours after one solve() of a fresh problem.
template <typename P>
struct PlannerAttempt
{
    Problem problem;
    std::shared_ptr<P> planner;
    ob::PlannerStatus status;
    std::vector<Eigen::VectorXd> path;  ///< configurations; empty without a solution

    double measure(const std::string &name) const
    {
        const auto found = planner->measures().find(name);
        return found == planner->measures().end() ? 0.0 : found->second;
    }
};

/// Seeds first, then builds everything anew; solves until the planner itself ends.
template <typename P>
PlannerAttempt<P> attempt(const std::string &name, const Scenario &scenario, std::uint32_t seed,
                          const std::map<std::string, std::string> &parameters, const ProblemOptions &options = {})
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seed);
    PlannerAttempt<P> result{makeProblem(scenario, options), nullptr, {}, {}};
    result.planner = std::dynamic_pointer_cast<P>(makePlanner(name, result.problem.context, parameters));
    result.planner->setProblemDefinition(result.problem.pdef);
    result.planner->setup();
    result.status = result.planner->solve(ob::plannerNonTerminatingCondition());
    if (result.problem.pdef->hasExactSolution())
        result.path =
            result.problem.space->unwrap(*result.problem.pdef->getSolutionPath()->template as<og::PathGeometric>());
    return result;
}
}  // namespace narrows
