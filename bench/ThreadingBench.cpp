// SPDX-License-Identifier: BSD-3-Clause
// Threader as a whole on the paper's cases, with members off, and its parts. Argument of the cases: their number.
#include <benchmark/benchmark.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "PaperCases.h"
#include "kernel/threading/CentredStep.h"
#include "kernel/threading/MidGap.h"
#include "planners/PlannerFactory.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
/// Whole solve(), another seed each time.
void solve(benchmark::State &run, const std::string &member)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const Scenario scenario = paperCase(static_cast<int>(run.range(0)));
    std::map<std::string, std::string> parameters;
    if (!member.empty())
        parameters[member] = "0";
    double placements = 0.0;
    std::uint_fast32_t seed = 0;
    for (auto _ : run)
    {
        run.PauseTiming();
        ompl::RNG::setSeed(++seed);
        const Problem problem = makeProblem(scenario, {"analytic", "continuous", "absolute"});
        const ob::PlannerPtr planner = makePlanner("threader", problem.context, parameters);
        planner->setProblemDefinition(problem.pdef);
        planner->setup();
        const auto condition = ob::plannerNonTerminatingCondition();
        run.ResumeTiming();
        if (planner->solve(condition) != ob::PlannerStatus::EXACT_SOLUTION)
            run.SkipWithError("not solved");
        run.PauseTiming();
        placements += static_cast<double>(problem.counts->placements.load());
        run.ResumeTiming();
    }
    run.counters["placements"] = benchmark::Counter(placements, benchmark::Counter::kAvgIterations);
}

BENCHMARK_CAPTURE(solve, all, "")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, without_slices, "slices")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, without_centring, "centring")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, without_bending, "bending")->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);

void findAllGaps(benchmark::State &run)
{
    const Scenario scenario = paperCase(static_cast<int>(run.range(0)));
    const PlanarModel &model = *scenario.planar().model;
    for (auto _ : run)
        benchmark::DoNotOptimize(findGaps(model.obstacles, model.arm.radius(), 0.05 * model.arm.reach()));
}
BENCHMARK(findAllGaps)->DenseRange(1, 3);

/// Argument: links. The chain's last link lies in a gap of half width 1e-4; each step moves it by a hundredth.
void centredStep(benchmark::State &run)
{
    const int count = static_cast<int>(run.range(0));
    std::vector<PlanarLink> links;
    for (int i = 0; i < count; ++i)
        links.push_back({1.0, i - 1});
    const PlanarArm arm({0, 0}, links);
    Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(count, 1.0, 0.0);
    std::vector<Eigen::Vector2d> points;
    arm.place(q, points);
    const Eigen::Vector2d middle = 0.5 * (points[count - 1] + points[count]), across(0.0, 0.3001);
    const MidGap midGap(arm,
                        findGaps({{"a", Circle{middle + across, 0.3}}, {"b", Circle{middle - across, 0.3}}}, 0.0, 0.1));
    CentredStep step(midGap);
    Eigen::VectorXd tangent, next;
    for (auto _ : run)
    {
        step.begin(q, {{count - 1, 0, true}});
        step.tangent(0.01 * Eigen::VectorXd::Unit(count, 0), tangent);
        if (!step.reach(tangent, next))
            run.SkipWithError("not reached");
    }
}
BENCHMARK(centredStep)->Arg(3)->Arg(6)->Arg(20);
}  // namespace
}  // namespace narrows
