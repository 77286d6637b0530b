// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "PaperCases.h"
#include "PlannerAttempt.h"
#include "planners/ElasticBand.h"
#include "planners/Threader.h"

namespace narrows
{
namespace
{
using Attempt = PlannerAttempt<Threader>;

/// The solution of Threader with a seed.
Attempt solved(const Scenario &scenario, std::uint32_t seed)
{
    Attempt found = attempt<Threader>("threader", scenario, seed, {}, {"analytic", "continuous", "absolute"});
    EXPECT_EQ(found.status, ob::PlannerStatus::EXACT_SOLUTION) << scenario.name;
    return found;
}

struct Polished
{
    BandReport report;
    og::PathGeometric before, path;
};

Polished polish(const Attempt &found, const BandWish &wish,
                const ob::PlannerTerminationCondition &ptc = ob::plannerNonTerminatingCondition())
{
    const og::PathGeometric before = *found.problem.pdef->getSolutionPath()->as<og::PathGeometric>();
    Polished result{{}, before, before};
    const JointChart chart(*found.problem.space);
    result.report = tightenBand(found.problem.si, chart, result.path, wish, ptc);
    return result;
}

Verdict judge(const Scenario &scenario, const Attempt &found, const og::PathGeometric &path)
{
    return verify(scenario.world, found.problem.space->unwrap(path));
}

TEST(ElasticBand, ComesOutStraightWhereNothingIsInTheWay)
{
    Scenario scenario = paperCase(2);
    auto model = std::make_shared<PlanarModel>(*scenario.planar().model);
    model->obstacles.clear();
    scenario.planar().model = model;
    const Attempt found = solved(scenario, 1);
    og::PathGeometric &path = *found.problem.pdef->getSolutionPath()->as<og::PathGeometric>();
    const double straight = path.length();
    ob::ScopedState<> aside(found.problem.si);
    found.problem.space->interpolate(path.getState(0), path.getState(1), 0.5, aside.get());
    for (unsigned int joint = 0; joint < found.problem.space->getDimension(); ++joint)
        aside[joint] += joint % 2 == 0 ? 0.4 : -0.3;
    og::PathGeometric bent(found.problem.si, path.getState(0), aside.get());
    bent.append(path.getState(1));
    path = bent;

    const Polished polished = polish(found, {0.0, 10.0, 0.2, 100000});
    EXPECT_NEAR(polished.report.before, bent.length(), 1e-9);
    EXPECT_NEAR(polished.path.length(), straight, 0.01 * straight);
    EXPECT_TRUE(found.problem.si->equalStates(polished.path.getState(0), bent.getState(0)));
    EXPECT_TRUE(found.problem.si->equalStates(
        polished.path.getState(static_cast<unsigned int>(polished.path.getStateCount()) - 1), bent.getState(2)));
}

TEST(ElasticBand, ShortensWhatStaysProven)
{
    for (const int number : {1, 2, 3})
    {
        const Scenario scenario = paperCase(number);
        const Attempt found = solved(scenario, 3);
        const Polished polished = polish(found, {});
        EXPECT_TRUE(judge(scenario, found, polished.path).accepted) << number;
        EXPECT_GT(polished.report.moves, 0) << number;
        EXPECT_LT(polished.path.length(), 0.95 * polished.before.length()) << number;
        EXPECT_NEAR(polished.path.length(), polished.report.after, 0.01 * polished.report.after) << number;
    }
}

// Into case 1's corridor the shortest way touches the wall: 6e-6 were measured; the goal itself has 0.0564.
TEST(ElasticBand, KeepsAwayFromObstaclesIfWished)
{
    const Scenario scenario = paperCase(1);
    for (std::uint32_t seed = 1; seed <= 2; ++seed)
    {
        const Attempt found = solved(scenario, seed);
        const Polished shorter = polish(found, {}), further = polish(found, {0.0564, 10.0, 0.1, 60});
        const Verdict close = judge(scenario, found, shorter.path), far = judge(scenario, found, further.path);
        ASSERT_TRUE(close.accepted && far.accepted);
        EXPECT_LT(close.clearance, 1e-3) << seed;
        EXPECT_GT(far.clearance, 0.04) << seed;
        EXPECT_LT(further.report.after, further.report.before) << seed;
        EXPECT_LT(further.path.length(), further.before.length()) << seed;
    }
}

TEST(ElasticBand, IsTheSameEveryTimeAndFreeWhenStopped)
{
    const Scenario scenario = paperCase(3);
    const Attempt found = solved(scenario, 1);
    const Polished one = polish(found, {}), two = polish(found, {});
    ASSERT_EQ(one.path.getStateCount(), two.path.getStateCount());
    for (unsigned int i = 0; i < one.path.getStateCount(); ++i)
        EXPECT_TRUE(found.problem.si->equalStates(one.path.getState(i), two.path.getState(i)));

    const Polished stopped = polish(found, {}, ob::plannerAlwaysTerminatingCondition());
    EXPECT_EQ(stopped.report.moves, 0);
    EXPECT_NEAR(stopped.path.length(), stopped.before.length(), 1e-2);
    EXPECT_TRUE(judge(scenario, found, stopped.path).accepted);
}
}  // namespace
}  // namespace narrows
