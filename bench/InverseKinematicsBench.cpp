// SPDX-License-Identifier: BSD-3-Clause
// What inverse kinematics of VDSM's manipulator costs: from joint centres, through cables and back, and by iteration at
// every waypoint of the paper's square (the first obstacle is in the model; nothing is checked here).
#include <benchmark/benchmark.h>

#include "PaperSquare.h"
#include "kernel/CableDrive.h"
#include "kernel/DampedTipSearch.h"
#include "kernel/PostureWish.h"
#include "planners/NloptTipSearch.h"

namespace narrows
{
namespace
{
using Eigen::VectorXd;

std::vector<VectorXd> randomPoses()
{
    std::mt19937 generator(5);
    const ChainGeometry chain = *chainGeometry(hyperRedundantArm());
    std::vector<VectorXd> poses;
    for (int i = 0; i < 256; ++i)
        poses.push_back(randomPose(chain, generator));
    return poses;
}

void valuesOfCentres(benchmark::State &state)
{
    const SpatialArm arm = hyperRedundantArm();
    const ChainGeometry chain = *chainGeometry(arm);
    std::vector<std::vector<Eigen::Vector3d>> centres;
    for (const VectorXd &pose : randomPoses())
        jointCentres(arm, pose, centres.emplace_back());
    VectorXd values;
    std::size_t i = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(valuesFromCentres(chain, centres[i++ % centres.size()], values));
}
BENCHMARK(valuesOfCentres);

void cablesOfAngles(benchmark::State &state)
{
    const CableDrive cables(hyperRedundantLengths());
    const std::vector<VectorXd> poses = randomPoses();
    VectorXd lengths;
    std::size_t i = 0;
    for (auto _ : state)
    {
        cables.totalLengths(poses[i++ % poses.size()].tail(16), lengths);
        benchmark::DoNotOptimize(lengths.data());
    }
}
BENCHMARK(cablesOfAngles);

void anglesOfCables(benchmark::State &state)
{
    const CableDrive cables(hyperRedundantLengths());
    std::vector<VectorXd> lengths;
    for (const VectorXd &pose : randomPoses())
        cables.totalLengths(pose.tail(16), lengths.emplace_back());
    std::size_t i = 0;
    for (auto _ : state)
        if (cables.anglesFromTotals(lengths[i++ % lengths.size()]).status != CableStatus::Solved)
            state.SkipWithError("no angles");
}
BENCHMARK(anglesOfCables);

SpatialModel modelWithFirstObstacle()
{
    const Cylinder obstacle{
        {0.0, 700.0, 600.0}, Eigen::Vector3d::UnitX(), 200.0, std::numeric_limits<double>::infinity()};
    return {hyperRedundantArm(), {{"obs1", obstacle}}};
}

std::unique_ptr<TipSearch> makeSearch(int method, const TipSearchTask &task)
{
    const auto poles = std::make_shared<const SpatialPoles>(modelWithFirstObstacle());
    DampedTipSearchOptions options;
    if (method == 0)
        return std::make_unique<DampedTipSearch>(poles->arm(), task, options);
    if (method == 3)
        return std::make_unique<NloptTipSearch>(poles, task, NloptOptions{false, 10.0});
    options.nullMotion = PostureWish(poles, {0.1, method == 1 ? 0.0 : 0.5, 80.0});
    return std::make_unique<DampedTipSearch>(poles->arm(), task, options);
}

void iterateAlongTheSquare(benchmark::State &state)
{
    const char *const names[] = {"damped least squares", "gradient projection, bends",
                                 "gradient projection, bends and obstacles", "NLopt SLSQP"};
    const PaperSquare square(true, 5.0);
    const auto search = makeSearch(static_cast<int>(state.range(0)), {7, 1e-3, 200,
                                                                      [](VectorXd &)
                                                                      {
                                                                          return false;
                                                                      }});
    std::size_t waypoints = 0;
    int iterations = 0;
    int missed = 0;
    for (auto _ : state)
    {
        VectorXd q = VectorXd::Zero(17);
        for (const Eigen::Vector3d &tip : square.tips())
        {
            const TipSearchResult result = search->reach(tip, q);
            iterations += result.iterations;
            missed += result.status != TipSearchStatus::Reached;
        }
        waypoints += square.tips().size();
    }
    state.SetLabel(names[state.range(0)]);
    const auto count = static_cast<double>(waypoints);
    state.counters["per_waypoint"] =
        benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["iterations"] = iterations / count;
    state.counters["missed"] = missed / count;
}
BENCHMARK(iterateAlongTheSquare)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace narrows
