// SPDX-License-Identifier: BSD-3-Clause
// What the workspace fields of tight maneuvering cost. Arguments: the scene (0 the pipe with its room, 1 the pipe
// alone, 2 seven hundred boxes) and tenths of the edge of a cell; the paper needs 13 s for its field, on another
// machine and in a scene that it does not give in numbers.
#include <benchmark/benchmark.h>

#include "TightScenes.h"
#include "kernel/fields/CorridorClasses.h"
#include "kernel/fields/DistanceField.h"
#include "kernel/fields/FieldStreamline.h"
#include "kernel/fields/LaplaceSweeps.h"

namespace narrows
{
namespace
{
struct FieldScene
{
    VoxelGrid<3> grid;
    Eigen::Vector3d start, goal;
};

FieldScene sceneOf(const benchmark::State &state)
{
    const double spacing = 0.1 * static_cast<double>(state.range(1));
    if (state.range(0) == 2)
        return {clutterGrid(700, spacing, 3.0), {40, 240, 240}, {760, 100, 380}};
    const double from = state.range(0) == 0 ? 0.0 : 220.0;
    return {bentPipe(spacing, from), {from + 40, 240, 60}, bentPipeLine().back()};
}

void describe(benchmark::State &state, const FieldScene &scene)
{
    state.counters["cells"] = scene.grid.cells();
    state.counters["free"] = scene.grid.freeCells();
}

void describe(benchmark::State &state, const FieldScene &scene, const LaplaceField &field)
{
    describe(state, scene);
    if (field.phi.empty())
    {
        state.SkipWithError(toText(field.failure).c_str());
        return;
    }
    const auto line = followField(scene.grid, field.phi, scene.start, scene.goal);
    state.counters["converged"] = field.failure == LaplaceFailure::None ? 1 : 0;
    state.counters["phi_start"] = field.phi[scene.grid.cellAround(scene.start)];
    state.counters["reached"] = line.failure == StreamlineFailure::None ? 1 : 0;
    state.counters["length"] = lengthOf<3>(line.path);
    state.counters["residual"] = field.residual;
    state.counters["sweeps"] = field.sweeps;
}

void occupyClutter(benchmark::State &state)
{
    const double spacing = 0.1 * static_cast<double>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(clutterGrid(700, spacing, 3.0).cells());
}
BENCHMARK(occupyClutter)->Arg(50)->Arg(29)->Unit(benchmark::kMillisecond);

void distances(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(distanceField(scene.grid, GridBorder::Wall).data());
    describe(state, scene);
}

/// The third argument: 0 steps to faces, 1 all steps.
void corridor(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    const auto clearance = distanceField(scene.grid, GridBorder::Wall);
    CorridorOptions options;
    options.steps = state.range(2) == 0 ? CellSteps::Faces : CellSteps::All;
    Corridor<3> found;
    for (auto _ : state)
        found = findCorridor(scene.grid, clearance, scene.start, scene.goal, options);
    describe(state, scene);
    state.counters["length"] = lengthOf<3>(found.path);
    state.counters["clearance"] = found.clearance;
}

void threeCorridors(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    const auto clearance = distanceField(scene.grid, GridBorder::Wall);
    std::size_t count = 0;
    for (auto _ : state)
        count = findCorridors(scene.grid, clearance, scene.start, scene.goal).size();
    describe(state, scene);
    state.counters["found"] = static_cast<double>(count);
}

void factorLaplace(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    for (auto _ : state)
    {
        const LaplaceSystem<3> system(scene.grid);
        if (system.failure() != LaplaceFailure::None)
            state.SkipWithError(toText(system.failure()).c_str());
        state.counters["factor"] = static_cast<double>(system.factorSize());
    }
    describe(state, scene);
}

void solveLaplace(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    const LaplaceSystem<3> system(scene.grid);
    LaplaceField field;
    for (auto _ : state)
        field = system.solve(scene.goal);
    describe(state, scene, field);
}

void sweepLaplace(benchmark::State &state)
{
    const FieldScene scene = sceneOf(state);
    LaplaceField field;
    for (auto _ : state)
        field = laplaceBySweeps(scene.grid, scene.goal);
    describe(state, scene, field);
}

void allGrids(benchmark::internal::Benchmark *bench)
{
    bench->Args({0, 50})->Args({1, 52})->Args({1, 26})->Args({2, 50})->Args({2, 29})->Unit(benchmark::kMillisecond);
}
BENCHMARK(distances)->Apply(allGrids);
BENCHMARK(corridor)
    ->ArgsProduct({{0, 2}, {50}, {0, 1}})
    ->ArgsProduct({{1}, {26}, {0, 1}})
    ->ArgsProduct({{2}, {29}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(threeCorridors)->Args({2, 50})->Unit(benchmark::kMillisecond);
BENCHMARK(factorLaplace)->Args({1, 100})->Args({1, 52})->Args({1, 26})->Unit(benchmark::kMillisecond);
BENCHMARK(solveLaplace)->Args({1, 100})->Args({1, 52})->Unit(benchmark::kMillisecond);
BENCHMARK(sweepLaplace)->Apply(allGrids)->Iterations(1);
}  // namespace
}  // namespace narrows
