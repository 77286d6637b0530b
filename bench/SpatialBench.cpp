// SPDX-License-Identifier: BSD-3-Clause
// What a robot in space costs: distances of one link, one check of an arm, one evaluation of its poles.
#include <benchmark/benchmark.h>

#include "SpatialScenes.h"
#include "kernel/SpatialRepulsionModel.h"
#include "validity/ArmChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr int kinds = obstacleKinds + 1;  // one more mesh, of 12 * 16^2 triangles

SpatialObstacle obstacleOf(int kind)
{
    std::mt19937 generator(3);
    if (kind < obstacleKinds)
        return randomObstacle(kind, generator);
    return {"fine mesh", boxMesh(randomBox(generator), 16)};
}

void distanceOfALink(benchmark::State &state)
{
    const SpatialObstacle obstacle = obstacleOf(static_cast<int>(state.range(0)));
    std::mt19937 generator(4);
    std::vector<std::pair<Vector3d, Vector3d>> links;
    for (int i = 0; i < 256; ++i)
        links.emplace_back(randomPoint(1.5, generator), randomPoint(1.5, generator));
    std::size_t i = 0;
    const auto measure = [&](const auto &shape)
    {
        for (auto _ : state)
        {
            const auto &[a, b] = links[i++ % links.size()];
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshGeometry>)
                benchmark::DoNotOptimize(shape.nearest(a, b));
            else
                benchmark::DoNotOptimize(nearness(a, b, shape));
        }
    };
    std::visit(
        [&](const auto &shape)
        {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
                measure(MeshGeometry(shape));
            else
                measure(shape);
        },
        obstacle.shape);
    state.SetLabel(obstacle.name);
}
BENCHMARK(distanceOfALink)->DenseRange(0, kinds - 1);

/// Six joints among five obstacles that are out of reach of the base.
SpatialModel scene()
{
    std::mt19937 generator(8);
    SpatialModel model{sixAxisArm(), {}, true};
    for (int kind = 0; kind < 5; ++kind)
    {
        model.obstacles.push_back(randomObstacle(kind, generator));
        std::visit(ShiftBy{1.3 * randomPoint(1.0, generator).normalized()}, model.obstacles.back().shape);
    }
    return model;
}

void placement(benchmark::State &state)
{
    const SpatialArm arm = sixAxisArm();
    std::mt19937 generator(5);
    const Eigen::VectorXd q = randomVector(6, 1.0, generator);
    SpatialArm::Placement placed;
    for (auto _ : state)
    {
        arm.place(q, placed);
        benchmark::DoNotOptimize(placed.points.data());
    }
}
BENCHMARK(placement);

void checkOfAState(benchmark::State &state)
{
    const auto checker = makeArmChecker(state.range(0) == 0 ? "analytic" : "fcl", scene());
    std::mt19937 generator(5);
    std::vector<Eigen::VectorXd> states;
    for (int i = 0; i < 256; ++i)
        states.push_back(randomVector(6, 1.5, generator));
    std::size_t i = 0, free = 0;
    for (auto _ : state)
        free += checker->isFree(states[i++ % states.size()]);
    state.counters["free"] = static_cast<double>(free) / static_cast<double>(i);
}
BENCHMARK(checkOfAState)->Arg(0)->Arg(1);

void checkOfAMotion(benchmark::State &state)
{
    const auto checker = makeArmChecker(state.range(0) == 0 ? "analytic" : "fcl", scene());
    std::mt19937 generator(5);
    std::vector<Eigen::VectorXd> states, ways;
    while (states.size() < 256)
    {
        const Eigen::VectorXd q = randomVector(6, 1.5, generator);
        if (!checker->isFree(q))
            continue;
        states.push_back(q);
        ways.push_back(randomVector(6, 0.3, generator));
    }
    std::size_t i = 0, free = 0;
    std::uint64_t placements = 0;
    for (auto _ : state)
    {
        free += checker->isMotionFree(states[i % 256], ways[i % 256], placements);
        ++i;
    }
    state.counters["free"] = static_cast<double>(free) / static_cast<double>(i);
    state.counters["placements"] = static_cast<double>(placements) / static_cast<double>(i);
}
BENCHMARK(checkOfAMotion)->Arg(0)->Arg(1);

void evaluationOfPoles(benchmark::State &state)
{
    const auto model = spatialRepulsionModel(std::make_shared<const SpatialModel>(scene()));
    const auto repulsion = model->continuous(std::vector<double>(model->groups().size(), 0.1));
    std::mt19937 generator(5);
    const Eigen::VectorXd q = randomVector(6, 1.0, generator);
    Repulsion::Sample sample;
    for (auto _ : state)
    {
        repulsion->evaluate(q, sample);
        benchmark::DoNotOptimize(sample.value);
    }
}
BENCHMARK(evaluationOfPoles);
}  // namespace
}  // namespace narrows
