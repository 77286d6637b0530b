// SPDX-License-Identifier: BSD-3-Clause
// What via-point trajectories cost: closed form against the paper's iteration, evaluation, splines, exact peaks.
#include <benchmark/benchmark.h>

#include "ViaPointPaper.h"
#include "kernel/trajectory/ViaPointIteration.h"
#include "kernel/trajectory/ViaPointSpline.h"

namespace narrows
{
namespace
{
const PaperTrajectory figures[] = {paperFig2, paperFig4, paperFig6, paperFig8, paperFig9};

/// With the logarithms of both bases and all checks of the parameters.
void closedForm(benchmark::State &state)
{
    PaperTrajectory paper = figures[state.range(0)];
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(paper);
        benchmark::DoNotOptimize(ViaPointTrajectory::paper(paper.task, paper.parameters));
    }
}
BENCHMARK(closedForm)->DenseRange(0, 4);

void paperIteration(benchmark::State &state)
{
    const PaperTrajectory &paper = figures[state.range(0)];
    for (auto _ : state)
        benchmark::DoNotOptimize(iterateFeedback(paper.task, paper.parameters, paper.task.via, 100000));
}
BENCHMARK(paperIteration)->DenseRange(0, 4);

template <int Order>
void evaluation(benchmark::State &state)
{
    const ViaPointTrajectory motion =
        state.range(0) < 5 ? trajectoryOf(figures[state.range(0)]) : *ViaPointTrajectory::full(paperTaskC, 1.5, 0.6);
    double t = 0.0;
    for (auto _ : state)
    {
        t = t > 2.9 ? 0.1 : t + 0.0123;
        benchmark::DoNotOptimize(motion.at<Order>(t));
    }
}
BENCHMARK(evaluation<0>)->Arg(0)->Arg(3)->Arg(5);
BENCHMARK(evaluation<3>)->Arg(0)->Arg(3)->Arg(5);

/// 39 vias, 7 joints: windows, matrix, solution for all joints.
void splineOf39Vias(benchmark::State &state)
{
    Eigen::MatrixXd points(7, 41);
    std::vector<double> times;
    for (Eigen::Index i = 0; i < points.cols(); ++i)
    {
        times.push_back(0.25 * static_cast<double>(i));
        for (Eigen::Index j = 0; j < points.rows(); ++j)
            points(j, i) = std::sin(static_cast<double>(3 * i + 5 * j));
    }
    const Rise rise = state.range(0) == 0   ? *Rise::resting(1.0)
                      : state.range(0) == 1 ? *Rise::symmetric(0.75)
                                            : Rise::quintic();
    for (auto _ : state)
        benchmark::DoNotOptimize(ViaPointSpline::through(points, times, 0.5, rise));
}
BENCHMARK(splineOf39Vias)->DenseRange(0, 2);

void exactPeaks(benchmark::State &state)
{
    const ViaPointTrajectory motion = *ViaPointTrajectory::full(paperTaskC, 1.5, 0.6);
    const double tolerance = state.range(0) == 0 ? 1e-4 : 1e-9;
    for (auto _ : state)
        benchmark::DoNotOptimize(motionPeaks(motion, tolerance));
}
BENCHMARK(exactPeaks)->Arg(0)->Arg(1);
}  // namespace
}  // namespace narrows
