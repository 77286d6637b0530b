// SPDX-License-Identifier: BSD-3-Clause
// The paper's curves in both forms, by the recipes of the scenario files, without certificates: what following the
// curve costs. Argument: case.
#include <benchmark/benchmark.h>
#include <ompl/util/Console.h>

#include "PaperCases.h"
#include "planners/PlannerFactory.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
/// Whole solve(): curve and certificate.
void solve(benchmark::State &run, const std::string &form)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const Scenario scenario = paperCase(static_cast<int>(run.range(0)));
    std::map<std::string, std::string> parameters = scenario.methods.at("hppm");
    parameters["form"] = form;
    double evaluations = 0.0;
    for (auto _ : run)
    {
        run.PauseTiming();
        const Problem problem = makeProblem(scenario);
        const ob::PlannerPtr planner = makePlanner("hppm", problem.context, parameters);
        planner->setProblemDefinition(problem.pdef);
        planner->setup();
        const auto condition = ob::plannerNonTerminatingCondition();
        run.ResumeTiming();
        if (planner->solve(condition) != ob::PlannerStatus::EXACT_SOLUTION)
            run.SkipWithError("not solved");
        run.PauseTiming();
        evaluations = static_cast<double>(problem.counts->placements.load());
        run.ResumeTiming();
    }
    run.counters["placements"] = evaluations;
}

BENCHMARK_CAPTURE(solve, plane, "plane")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, full, "full")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);
}  // namespace
}  // namespace narrows
