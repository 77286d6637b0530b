// SPDX-License-Identifier: BSD-3-Clause
// What one question to a checker costs. The paper's three cases: states spread over the whole joint space or crowded
// near the goal, where the narrow passages are (arguments: case, 0 = uniform / 1 = near the goal). The last motion into
// the corridor of case 1, while it closes (argument: exponent of the clearance 10^-n). armCheck and armBatch ask
// without OMPL in between, one by one and many at once: the checkers, and the scalar one that the analytic one must
// agree with.
#include <algorithm>

#include <benchmark/benchmark.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "CorridorScene.h"
#include "PaperCases.h"
#include "ScalarChecker.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
constexpr int stateCount = 1024;

/// The same questions in every run.
struct Question
{
    Question(const benchmark::State &run, const std::string &checker, const std::string &motion = "continuous")
      : scenario(paperCase(static_cast<int>(run.range(0)))),
        problem(makeProblem(scenario, {checker, motion, "absolute"}))
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // setSeed() says that it comes late
        ompl::RNG::setSeed(1);
        ompl::base::ScopedState<> goal(problem.si);
        problem.space->fromConfiguration(std::get<Eigen::VectorXd>(scenario.planar().task.goal), goal.get());
        const ob::StateSamplerPtr sampler = problem.si->allocStateSampler();
        while (states.size() < stateCount)
        {
            ob::State *state = problem.si->allocState();
            if (run.range(1) == 0)
                sampler->sampleUniform(state);
            else
                sampler->sampleGaussian(state, goal.get(), 0.05);
            states.push_back(state);
        }
    }

    ~Question()
    {
        for (ob::State *state : states)
            problem.si->freeState(state);
    }

    Scenario scenario;
    Problem problem;
    std::vector<ob::State *> states;
};

void stateCheck(benchmark::State &run, const std::string &checker)
{
    const Question question(run, checker);
    std::size_t i = 0;
    int valid = 0;
    for (auto _ : run)
        valid += question.problem.si->isValid(question.states[i++ % stateCount]);
    run.counters["valid"] = benchmark::Counter(valid, benchmark::Counter::kAvgIterations);
}

/// Short motions between neighbouring samples, as a tree asks for them.
void askAboutMotions(benchmark::State &run, const Question &question)
{
    ob::State *to = question.problem.si->allocState();
    std::size_t i = 0;
    const auto before = question.problem.counts->placements.load();
    for (auto _ : run)
    {
        const ob::State *from = question.states[i % stateCount];
        question.problem.space->interpolate(from, question.states[(i + 1) % stateCount], 0.1, to);
        ++i;
        benchmark::DoNotOptimize(question.problem.si->checkMotion(from, to));
    }
    run.counters["placements"] = benchmark::Counter(
        static_cast<double>(question.problem.counts->placements.load() - before), benchmark::Counter::kAvgIterations);
    question.problem.si->freeState(to);
}

void motionCheck(benchmark::State &run, const std::string &checker)
{
    askAboutMotions(run, Question(run, checker));
}

/// The same at a resolution of 0.001, by our validator, which asks about many states at once, or by OMPL's.
void sampledMotion(benchmark::State &run, bool own)
{
    const Question question(run, "analytic", "0.001");
    if (!own)
        question.problem.si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(question.problem.si));
    askAboutMotions(run, question);
}

template <class Checker>
void askAboutArms(benchmark::State &run, const Question &question, const Checker &checker)
{
    std::vector<Eigen::VectorXd> configurations(question.states.size());
    for (std::size_t k = 0; k < configurations.size(); ++k)
        question.problem.space->toConfiguration(question.states[k], configurations[k]);
    std::size_t i = 0;
    int free = 0;
    for (auto _ : run)
        free += checker.isFree(configurations[i++ % stateCount]);
    run.counters["free"] = benchmark::Counter(free, benchmark::Counter::kAvgIterations);
}

void armCheck(benchmark::State &run, const std::string &name)
{
    const Question question(run, "analytic");
    askAboutArms(run, question, *makeArmChecker(name, *question.scenario.planar().model));
}

void scalarArmCheck(benchmark::State &run)
{
    const Question question(run, "analytic");
    askAboutArms(run, question, ScalarChecker(*question.scenario.planar().model));
}

/// 256 states at once; `time` is that of one.
void armBatch(benchmark::State &run, const std::string &name)
{
    const Question question(run, "analytic");
    const PlanarModel &model = *question.scenario.planar().model;
    const auto checker = makeArmChecker(name, model);
    constexpr int batchSize = 256;
    std::vector<Eigen::MatrixXd> batches(stateCount / batchSize, Eigen::MatrixXd(batchSize, model.arm.dimension()));
    Eigen::VectorXd q;
    for (int k = 0; k < stateCount; ++k)
    {
        question.problem.space->toConfiguration(question.states[k], q);
        batches[k / batchSize].row(k % batchSize) = q;
    }
    std::vector<char> free;
    std::int64_t asked = 0, count = 0;
    for (auto _ : run)
    {
        checker->areFree(batches[asked++ % batches.size()], free);
        count += std::count(free.begin(), free.end(), 1);
    }
    run.counters["free"] = static_cast<double>(count) / static_cast<double>(asked * batchSize);
    run.counters["time"] = benchmark::Counter(static_cast<double>(asked * batchSize),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void intoTheCorridor(benchmark::State &run)
{
    const CorridorMotion motion(std::pow(10.0, -static_cast<double>(run.range(0))));
    const auto checker = makeArmChecker("analytic", motion.model);
    std::uint64_t placements = 0;
    for (auto _ : run)
        if (!checker->isMotionFree(motion.q, motion.delta, placements))
            run.SkipWithError("not free");
    run.counters["placements"] =
        benchmark::Counter(static_cast<double>(placements), benchmark::Counter::kAvgIterations);
}

BENCHMARK_CAPTURE(stateCheck, analytic, "analytic")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(stateCheck, fcl, "fcl")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK(scalarArmCheck)->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(armCheck, analytic, "analytic")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(armCheck, fcl, "fcl")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(armBatch, analytic, "analytic")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(armBatch, fcl, "fcl")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(motionCheck, analytic, "analytic")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(motionCheck, fcl, "fcl")->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(sampledMotion, own, true)->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK_CAPTURE(sampledMotion, ompl, false)->ArgsProduct({{1, 2, 3}, {0, 1}});
BENCHMARK(intoTheCorridor)->DenseRange(2, 7);
}  // namespace
}  // namespace narrows
