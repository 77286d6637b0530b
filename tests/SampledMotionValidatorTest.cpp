// SPDX-License-Identifier: BSD-3-Clause
// Our sampled validator against OMPL's own, motion by motion.
#include "validity/SampledMotionValidator.h"

#include <random>

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>

#include "PaperCases.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
struct Tally
{
    int free = 0, partlyFree = 0;
};

/// Long and short motions from valid states near the goal, where it is narrow.
Tally compare(const Problem &problem, const Eigen::VectorXd &goal, int motions)
{
    const ob::DiscreteMotionValidator expected(problem.si);
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    const auto near = [&](const Eigen::VectorXd &q, double spread)
    {
        Eigen::VectorXd result = q;
        for (double &angle : result)
            angle += spread * normal(generator);
        return result;
    };
    ob::ScopedState<> from(problem.si), to(problem.si), last(problem.si), expectedLast(problem.si);
    Tally tally;
    while (motions > 0)
    {
        const Eigen::VectorXd q = near(goal, 0.05);
        problem.space->fromConfiguration(q, from.get());
        if (!problem.si->isValid(from.get()))
            continue;
        --motions;
        problem.space->fromConfiguration(near(q, motions % 2 == 0 ? 0.03 : 0.6), to.get());
        const bool free = expected.checkMotion(from.get(), to.get());
        EXPECT_EQ(problem.si->checkMotion(from.get(), to.get()), free);
        std::pair<ob::State *, double> until{last.get(), -1.0}, expectedUntil{expectedLast.get(), -1.0};
        EXPECT_EQ(expected.checkMotion(from.get(), to.get(), expectedUntil), free);
        EXPECT_EQ(problem.si->getMotionValidator()->checkMotion(from.get(), to.get(), until), free);
        EXPECT_EQ(until.second, expectedUntil.second);
        EXPECT_TRUE(free || problem.si->equalStates(last.get(), expectedLast.get()));
        tally.free += free;
        tally.partlyFree += until.second > 0.0;
    }
    return tally;
}

TEST(SampledMotionValidator, AnswersAsOmplsOwn)
{
    for (const int number : {1, 2, 3})
        for (const char *checker : {"analytic", "fcl"})
            for (const char *space : {"absolute", "relative", "absolute_line"})
            {
                const Scenario scenario = paperCase(number);
                const Tally tally = compare(makeProblem(scenario, {checker, "0.002", space}),
                                            std::get<Eigen::VectorXd>(scenario.planar().task.goal), 150);
                EXPECT_GT(tally.free, 5) << number << checker << space;
                EXPECT_GT(tally.partlyFree, 15) << number << checker << space;
            }
}

TEST(SampledMotionValidator, CountsWhatItDoes)
{
    const Problem problem = makeProblem(paperCase(2), {"analytic", "0.002", "absolute"});
    ob::ScopedState<> from(problem.si), to(problem.si);
    problem.space->fromConfiguration(std::get<Eigen::VectorXd>(paperCase(2).planar().task.goal), from.get());
    to = from;
    to[0] += 1e-3;
    const auto states = problem.counts->stateChecks.load();
    ASSERT_TRUE(problem.si->checkMotion(from.get(), to.get()));
    EXPECT_EQ(problem.counts->motionChecks.load(), 1u);
    EXPECT_EQ(problem.counts->stateChecks.load() - states, problem.space->validSegmentCount(from.get(), to.get()));
}
}  // namespace
}  // namespace narrows
