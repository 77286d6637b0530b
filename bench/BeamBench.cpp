// SPDX-License-Identifier: BSD-3-Clause
// What the beams of tight maneuvering cost, in the duct with thirteen bends and among seven hundred boxes. Arguments:
// couples of beams and the spacing of their stations. The paper needs 15.7 s for 6564 beams and 32.5 s for 13128, in a
// scene that it does not give in numbers. And what it costs to exclude a link length in the short S-bend, by the edge
// of the cells.
#include <benchmark/benchmark.h>

#include "LadderScenes.h"
#include "kernel/beams/BeamPath.h"
#include "kernel/chain/LadderSearch.h"

namespace narrows
{
namespace
{
ChainScene<3> spatialScene(const std::string &family)
{
    return std::get<ChainScene<3>>(findFamily(family).draw(findFamily(family).values({})));
}

/// Axis-parallel pieces from the entrance to the goal, and the middle of the duct with thirteen bends.
const PointPath<3> ductMiddle{{40, 240, 60},   {320, 240, 60},  {320, 240, 300}, {320, 420, 300}, {440, 420, 300},
                              {440, 420, 100}, {440, 180, 100}, {560, 180, 100}, {560, 180, 400}, {560, 60, 400},
                              {680, 60, 400},  {680, 60, 140},  {680, 300, 140}, {800, 300, 140}, {800, 300, 400}};

void castInDuct(benchmark::State &state)
{
    const ChainScene<3> scene = spatialScene("maze3d");
    const auto distance = signedDistance<3>(scene.walls);
    BeamOptions options;
    options.fan.linkLength = 84.0;
    options.fan.radius = scene.radius;
    options.fan.couples = static_cast<int>(state.range(0));
    options.fan.spacing = static_cast<double>(state.range(1));
    options.window = 20.0;
    BeamPath<3> path;
    for (auto _ : state)
        benchmark::DoNotOptimize(path = beamPath<3>(ductMiddle, distance, options));
    state.counters["beams"] = path.beams;
    state.counters["regions"] = static_cast<double>(path.regions.size());
    state.counters["failed"] = path.failure == BeamFailure::None ? 0 : 1;
    state.counters["us_per_beam"] = benchmark::Counter(
        1e-6 * path.beams, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void exclude(benchmark::State &state)
{
    const ChainScene<2> scene = ladderScene("Z300");
    const AxisBox<2> bounds = boundsOf(scene.walls);
    LadderSearchOptions options;
    options.spacing = static_cast<double>(state.range(0));
    options.finestAngle = 0.00125 * options.spacing;
    const LadderTask task{scene.entrance, {0.0, 1.0},   scene.goal,   scene.tolerance,
                          560.0,          scene.radius, bounds.lower, bounds.upper};
    LadderSearch search;
    for (auto _ : state)
        benchmark::DoNotOptimize(search = excludeLadder(task, signedDistance<2>(scene.walls), options));
    state.counters["cells"] = static_cast<double>(search.cells);
    state.counters["nodes"] = static_cast<double>(search.nodes);
    state.counters["excluded"] = search.verdict == LadderVerdict::Excluded ? 1 : 0;
}

BENCHMARK(castInDuct)->ArgsProduct({{1, 2, 4}, {8, 4, 2}})->Unit(benchmark::kMillisecond);
BENCHMARK(exclude)->Arg(16)->Arg(8)->Arg(4)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace narrows
