// SPDX-License-Identifier: BSD-3-Clause
// What PlannerContractTest asks of planners, of those that follow tip paths, and of some that are led along them.
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Exception.h>

#include "TipPathScenes.h"

namespace narrows
{
namespace
{
constexpr long enough = 20'000;  // questions

/// Nothing is in the way; the pipe is there to be looked at.
Scenario scenario()
{
    const Cylinder pipe{{0.0, 700.0, 600.0}, Eigen::Vector3d::UnitX(), 200.0, std::numeric_limits<double>::infinity()};
    return manipulatorScenario({{3126.0, 0.0, -200.0}, {3126.0, 200.0, -200.0}, {3126.0, 0.0, 0.0}}, {{"pipe", pipe}});
}

class TipPathContract : public testing::TestWithParam<std::string>
{
protected:
    static Trial make() { return spatialTrial(GetParam(), scenario()); }
};

TEST_P(TipPathContract, ExactSolutionIsProven)
{
    const Trial trial = make();
    const ob::PlannerStatus status = trial.planner->solve(questions(enough));
    expectTruthful(status, *trial.problem.pdef);
    ASSERT_EQ(type(status), ob::PlannerStatus::EXACT_SOLUTION) << status.asString();
    const Verdict verdict = verdictOf(scenario(), trial);
    EXPECT_TRUE(verdict.accepted) << verdict.reason << ' ' << verdict.tip;
    EXPECT_TRUE(trial.path().check());
}

TEST_P(TipPathContract, SecondSolveKeepsTheSolution)
{
    const Trial trial = make();
    trial.planner->solve(questions(enough));
    EXPECT_EQ(type(trial.planner->solve(questions(enough))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(trial.problem.pdef->hasExactSolution());
}

TEST_P(TipPathContract, SolvesAgainAfterClear)
{
    const Trial trial = make();
    trial.planner->solve(questions(enough));
    trial.planner->clear();
    trial.problem.pdef->clearSolutionPaths();
    ASSERT_EQ(type(trial.planner->solve(questions(enough))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(verdictOf(scenario(), trial).accepted);
}

TEST_P(TipPathContract, EndsAtOnceWhenTold)
{
    const Trial trial = make();
    const ob::PlannerStatus status = trial.planner->solve(ob::plannerAlwaysTerminatingCondition());
    expectTruthful(status, *trial.problem.pdef);
    EXPECT_FALSE(trial.problem.pdef->hasExactSolution());
    EXPECT_LT(trial.problem.counts->motionChecks, 10U);
}

TEST_P(TipPathContract, WhatItReachesInTooLittleTimeIsFree)
{
    for (const long limit : {2, 10, 40, 120})
    {
        const Trial trial = make();
        const ob::PlannerStatus status = trial.planner->solve(questions(limit));
        expectTruthful(status, *trial.problem.pdef);
        if (type(status) != ob::PlannerStatus::APPROXIMATE_SOLUTION)
            continue;
        const std::vector<Eigen::VectorXd> rows = trial.problem.space->unwrap(trial.path());
        SpatialWorld prefix = scenario().spatial();
        prefix.task.goal = rows.back();
        EXPECT_EQ(verify(World(prefix), rows).reason, "") << limit;
        EXPECT_GT(trial.problem.pdef->getSolutionDifference(), 0.0);
    }
}

TEST_P(TipPathContract, EndsWithoutAWay)
{
    Problem problem = seeded(scenario());
    const ob::State *start = problem.pdef->getStartState(0);
    problem.si->setStateValidityChecker([&problem, start](const ob::State *state)
                                        { return problem.si->equalStates(state, start); });
    problem.si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(problem.si));
    problem.si->setup();
    const ob::PlannerPtr planner = makePlanner(GetParam(), problem.context);
    planner->setProblemDefinition(problem.pdef);
    planner->setup();
    const ob::PlannerStatus status = planner->solve(questions(100));
    expectTruthful(status, *problem.pdef);
    EXPECT_FALSE(problem.pdef->hasExactSolution());
}

TEST_P(TipPathContract, NamesAnInvalidStart)
{
    const Trial trial = make();
    trial.problem.si->setStateValidityChecker([](const ob::State *) { return false; });
    trial.problem.si->setup();
    EXPECT_EQ(type(trial.planner->solve(questions(10))), ob::PlannerStatus::INVALID_START);
    EXPECT_FALSE(trial.problem.pdef->hasSolution());
}

TEST_P(TipPathContract, ThrowsWithoutAProblem)
{
    const Problem problem = seeded(scenario());
    const ob::PlannerPtr planner = makePlanner(GetParam(), problem.context);
    EXPECT_THROW(planner->solve(questions(10)), ompl::Exception);
    planner->setProblemDefinition(std::make_shared<ob::ProblemDefinition>(problem.si));
    EXPECT_THROW(planner->solve(questions(10)), ompl::Exception);
}

TEST_P(TipPathContract, ParametersSurviveClear)
{
    const Trial trial = make();
    std::map<std::string, std::string> before;
    std::map<std::string, std::string> after;
    trial.planner->params().getParams(before);
    trial.planner->solve(questions(enough));
    trial.planner->clear();
    trial.planner->params().getParams(after);
    EXPECT_FALSE(before.empty());
    EXPECT_EQ(before, after);
}

TEST_P(TipPathContract, DataMarkStartAndGoal)
{
    const Trial trial = make();
    trial.planner->solve(questions(enough));
    ob::PlannerData data(trial.problem.si);
    trial.planner->getPlannerData(data);
    EXPECT_GE(data.numVertices(), 2U);
    EXPECT_GE(data.numStartVertices(), 1U);
    EXPECT_GE(data.numGoalVertices(), 1U);
}

TEST_P(TipPathContract, SameSeedSamePath)
{
    const auto solve = []
    {
        Trial trial = make();
        trial.planner->solve(questions(enough));
        return trial;
    };
    const Trial first = solve();
    const Trial second = solve();
    EXPECT_EQ(first.problem.counts->stateChecks, second.problem.counts->stateChecks);
    EXPECT_EQ(first.problem.counts->motionChecks, second.problem.counts->motionChecks);
    EXPECT_EQ(first.problem.space->unwrap(first.path()), second.problem.space->unwrap(second.path()));
}

std::vector<std::string> names()
{
    std::vector<std::string> result{"rrtconnect", "rrt", "bkpiece1"};
    for (const PlannerEntry &entry : planners())
        if (entry.followsTipPath)
            result.push_back(entry.name);
    return result;
}

INSTANTIATE_TEST_SUITE_P(All, TipPathContract, testing::ValuesIn(names()),
                         [](const auto &planner) { return planner.param; });
}  // namespace
}  // namespace narrows
