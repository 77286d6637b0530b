// SPDX-License-Identifier: BSD-3-Clause
// What the scaling method costs: one waypoint of the VDSM paper's square around its first obstacle, with scaling, the
// rules of a pose, lift and inverse kinematics.
#include <benchmark/benchmark.h>

#include "PaperSquare.h"

namespace narrows
{
namespace
{
ScalingOptions optionsOf(ScalingMode mode)
{
    ScalingOptions options;
    options.mode = mode;
    // The tip runs along the boundary of the region of 100, which the taut string must not.
    options.margin = mode == ScalingMode::Taut ? 99.0 : 100.0;
    options.maxJump = 30.0;
    return options;
}

void scaleTheSquare(benchmark::State &state)
{
    const auto mode = static_cast<ScalingMode>(state.range(0));
    const ScalingProblem problem = state.range(1) == 0 ? paperProblem() : paperObstacle1();
    const PaperSquare square(state.range(1) != 0, 5.0);
    const ChainGeometry chain = *chainGeometry(hyperRedundantArm());
    std::vector<Eigen::Vector3d> centres;
    Eigen::VectorXd values;
    std::size_t poses = 0;
    for (auto _ : state)
    {
        const ScalingResult result = scalePath(problem, square.tips(), optionsOf(mode));
        if (result.fault)
            state.SkipWithError(toText(result.fault.failure).c_str());
        for (std::size_t p = 0; p < result.poses(); ++p)
        {
            centres.assign(result.pose(p), result.pose(p) + result.stride);
            if (!valuesFromCentres(chain, centres, values))
                state.SkipWithError("no joint values");
            benchmark::DoNotOptimize(values.data());
        }
        poses += result.poses();
    }
    state.counters["per_waypoint"] =
        benchmark::Counter(static_cast<double>(poses), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(scaleTheSquare)
    ->Args({static_cast<int>(ScalingMode::PaperVertical), 0})
    ->Args({static_cast<int>(ScalingMode::PaperVertical), 1})
    ->Args({static_cast<int>(ScalingMode::Taut), 0})
    ->Args({static_cast<int>(ScalingMode::Taut), 1});

void scaleInTheTopView(benchmark::State &state)
{
    const ScalingProblem problem = paperObstacle3();
    const PaperSquare square(false, 5.0);
    std::size_t poses = 0;
    for (auto _ : state)
        poses += scalePath(problem, square.tips(), optionsOf(ScalingMode::Taut)).poses();
    state.counters["per_waypoint"] =
        benchmark::Counter(static_cast<double>(poses), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(scaleInTheTopView);
}  // namespace
}  // namespace narrows
