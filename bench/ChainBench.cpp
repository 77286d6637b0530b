// SPDX-License-Identifier: BSD-3-Clause
// What tight maneuvering costs, links of 84: the fields and the middle path alone, a path from the grid to the
// certificate, the certificate alone, and the planner with the motions of all joints, proven. In the duct with thirteen
// bends and in the room with 700 boxes. The argument is the number of links; 35 of them fill the duct and the room
// before it, the others wait on the slide.
#include <benchmark/benchmark.h>

#include "planners/ChainRobot.h"
#include "planners/TightManeuvering.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
Scenario scenarioOf(benchmark::State &state, const std::string &scene)
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/tight_" + scene + ".yaml",
                        {{"links", std::to_string(state.range(0))}});
}

/// What the planner's search is given, and its first attempt.
struct Chain
{
    explicit Chain(const Scenario &scenario)
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

void findMiddlePath(benchmark::State &state, const std::string &scene)
{
    const Chain chain(scenarioOf(state, scene));
    const Eigen::Vector3d tip = chain.robot.centres(chain.world.task.start).back();
    std::string failure;
    for (auto _ : state)
    {
        TightWays<3> ways(chain.obstacles, chain.robot.spec(), chain.settings.grid);
        benchmark::DoNotOptimize(failure = ways.findFirst(tip, std::get<SpatialTipGoal>(chain.world.task.goal).point));
    }
    state.counters["failed"] = failure.empty() ? 0 : 1;
}

void searchPath(benchmark::State &state, const std::string &scene)
{
    const Chain chain(scenarioOf(state, scene));
    TightAttempt<3> attempt;
    for (auto _ : state)
        benchmark::DoNotOptimize(attempt = chain.search());
    state.counters["chords"] = attempt.certificate.chords;
    state.counters["failed"] = attempt.failure.empty() ? 0 : 1;
}

void certify(benchmark::State &state, const std::string &scene)
{
    const Chain chain(scenarioOf(state, scene));
    const LeaderPath<3> path(chain.search().nodes, chain.robot.axis());
    ChainCertificate certificate;
    for (auto _ : state)
        benchmark::DoNotOptimize(certificate = certifyChain<3>(path, chain.obstacles, chain.robot.spec()));
    state.counters["chords"] = certificate.chords;
    state.counters["failed"] = certificate ? 0 : 1;
}

void solve(benchmark::State &state, const std::string &scene)
{
    const Scenario scenario = scenarioOf(state, scene);
    double states = 0.0, failed = 0.0, margins = 0.0, asked = 0.0;
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
        margins = planner.measures().at("motions_by_margin");
        asked = static_cast<double>(problem.counts->motionChecks);
    }
    state.counters["states"] = states;
    state.counters["by_margin"] = margins;
    state.counters["validator_asked"] = asked;
    state.counters["failed"] = failed;
}

void fewLinks(benchmark::internal::Benchmark *benchmark)
{
    benchmark->Arg(35)->Unit(benchmark::kMillisecond);
}

void manyLinks(benchmark::internal::Benchmark *benchmark)
{
    benchmark->Arg(35)->Arg(70)->Arg(140)->Arg(280)->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(findMiddlePath, bends, "maze")->Apply(fewLinks);
BENCHMARK_CAPTURE(findMiddlePath, boxes, "boxes")->Apply(fewLinks);
BENCHMARK_CAPTURE(searchPath, bends, "maze")->Apply(manyLinks);
BENCHMARK_CAPTURE(searchPath, boxes, "boxes")->Apply(fewLinks);
BENCHMARK_CAPTURE(certify, bends, "maze")->Apply(manyLinks);
BENCHMARK_CAPTURE(solve, bends, "maze")->Apply(manyLinks);
BENCHMARK_CAPTURE(solve, boxes, "boxes")->Apply(fewLinks);
}  // namespace
}  // namespace narrows
