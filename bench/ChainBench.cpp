// SPDX-License-Identifier: BSD-3-Clause
// What tight maneuvering costs as the chain gets more links, in the duct with thirteen bends, links of 84: a path from
// the grid to the certificate, the certificate alone, and the planner with the motions of all joints, proven. The
// argument is the number of links; 35 of them fill the duct and the room before it, the others wait on the slide.
#include <benchmark/benchmark.h>

#include "planners/ChainRobot.h"
#include "planners/TightManeuvering.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
Scenario ductScenario(benchmark::State &state)
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/tight_maze.yaml",
                        {{"links", std::to_string(state.range(0))}});
}

/// What the planner's search is given, and its first attempt.
struct Duct
{
    explicit Duct(const Scenario &scenario)
      : problem(makeProblem(scenario)),
        world(scenario.spatial()),
        robot(*world.model, *problem.si->getStateSpace()->as<SpatialArmStateSpace>()),
        obstacles(world.model->obstacles)
    {
    }

    TightAttempt<3> search() const
    {
        const Eigen::Vector3d tip = robot.centres(world.task.start).back();
        TightSearch<3> search(obstacles, robot.spec(), settings, tip, robot.axis(),
                              std::get<SpatialTipGoal>(world.task.goal).point);
        return search.next([] { return false; });
    }

    Problem problem;
    SpatialWorld world;
    ChainRobot<3> robot;
    ChordObstacles<3> obstacles;
    TightSettings settings;
};

void searchPath(benchmark::State &state)
{
    const Duct duct(ductScenario(state));
    TightAttempt<3> attempt;
    for (auto _ : state)
        benchmark::DoNotOptimize(attempt = duct.search());
    state.counters["chords"] = attempt.certificate.chords;
    state.counters["failed"] = attempt.failure.empty() ? 0 : 1;
}

void certify(benchmark::State &state)
{
    const Duct duct(ductScenario(state));
    const LeaderPath<3> path(duct.search().nodes, duct.robot.axis());
    ChainCertificate certificate;
    for (auto _ : state)
        benchmark::DoNotOptimize(certificate = certifyChain<3>(path, duct.obstacles, duct.robot.spec()));
    state.counters["chords"] = certificate.chords;
    state.counters["failed"] = certificate ? 0 : 1;
}

void solve(benchmark::State &state)
{
    const Scenario scenario = ductScenario(state);
    double states = 0.0, failed = 0.0;
    for (auto _ : state)
    {
        state.PauseTiming();
        const Problem problem = makeProblem(scenario);
        TightManeuvering planner(problem.si, nullptr, scenario.spatial().model);
        planner.setProblemDefinition(problem.pdef);
        planner.setup();
        state.ResumeTiming();
        const ob::PlannerStatus status = planner.solve(ob::plannerNonTerminatingCondition());
        failed += status == ob::PlannerStatus::EXACT_SOLUTION ? 0.0 : 1.0;
        states = planner.measures().at("states");
    }
    state.counters["states"] = states;
    state.counters["failed"] = failed;
}

BENCHMARK(searchPath)->Arg(35)->Arg(70)->Arg(140)->Arg(280)->Unit(benchmark::kMillisecond);
BENCHMARK(certify)->Arg(35)->Arg(70)->Arg(140)->Arg(280)->Unit(benchmark::kMillisecond);
BENCHMARK(solve)->Arg(35)->Arg(70)->Arg(140)->Arg(280)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace narrows
