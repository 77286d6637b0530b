// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Exception.h>

#include "PlannerTrial.h"
#include "benchmark/AddressSanitizer.h"

#if NARROWS_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace narrows
{
namespace
{
/// Does not let the leak sanitizer see what planners known to leak allocate.
class LeakScope
{
public:
    explicit LeakScope([[maybe_unused]] bool leaks)
    {
#if NARROWS_ADDRESS_SANITIZER
        if (leaks)
            scope_ = std::make_unique<__lsan::ScopedDisabler>();
#endif
    }

private:
#if NARROWS_ADDRESS_SANITIZER
    std::unique_ptr<__lsan::ScopedDisabler> scope_;
#endif
};

class PlannerContract : public testing::TestWithParam<std::string>
{
protected:
    const std::string &name() const { return GetParam(); }
    bool is(Quirk quirk) const { return has(name(), quirk); }

private:
    LeakScope leakScope_{has(GetParam(), Quirk::Leaks)};
};

TEST_P(PlannerContract, ExactSolutionJoinsStartToGoal)
{
    const Trial trial = makeTrial(name());
    const ob::PlannerStatus status = trial.planner->solve(questions(enoughFor(name())));
    expectTruthful(status, *trial.problem.pdef);
    ASSERT_EQ(status != ob::PlannerStatus::EXACT_SOLUTION, is(Quirk::NeverExact)) << status.asString();
    if (status == ob::PlannerStatus::EXACT_SOLUTION)
        expectJoined(trial);
}

TEST_P(PlannerContract, StopsAtTheFirstSolution)
{
    const Trial trial = makeTrial(name());
    const Counter asked = counter();
    trial.planner->solve(questions(enoughFor(name()), asked));
    EXPECT_EQ(*asked > enoughFor(name()), is(Quirk::TakesAllTime) || is(Quirk::NeverExact));
}

TEST_P(PlannerContract, SecondSolveKeepsTheSolution)
{
    const Trial trial = makeTrial(name());
    const ob::PlannerStatus first = trial.planner->solve(questions(enoughFor(name())));
    const ob::PlannerStatus second = trial.planner->solve(questions(enoughFor(name())));
    EXPECT_EQ(second == ob::PlannerStatus::INVALID_START, is(Quirk::NoSecondSolve)) << second.asString();
    if (!is(Quirk::NoSecondSolve))
    {
        EXPECT_EQ(type(second), type(first)) << second.asString();
    }
    EXPECT_TRUE(trial.problem.pdef->hasSolution());
}

TEST_P(PlannerContract, SolvesAgainAfterClear)
{
    const Trial trial = makeTrial(name());
    const ob::PlannerStatus first = trial.planner->solve(questions(enoughFor(name())));
    trial.planner->clear();
    trial.problem.pdef->clearSolutionPaths();
    const ob::PlannerStatus second = trial.planner->solve(questions(enoughFor(name())));
    expectTruthful(second, *trial.problem.pdef);
    EXPECT_EQ(type(second), type(first));
    if (second == ob::PlannerStatus::EXACT_SOLUTION)
        expectJoined(trial);
}

TEST_P(PlannerContract, EndsAtOnceWhenTold)
{
    const Trial trial = makeTrial(name());
    const ob::PlannerStatus status = trial.planner->solve(ob::plannerAlwaysTerminatingCondition());
    expectTruthful(status, *trial.problem.pdef);
    EXPECT_LT(trial.problem.counts->motionChecks, 10U);
}

TEST_P(PlannerContract, EndsWithoutAWay)
{
    Problem problem = seededProblem(name());
    problem.si->setStateValidityChecker(std::make_shared<TwoStates>(problem));
    problem.si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(problem.si));
    problem.si->setup();
    const Trial trial = makeTrial(name(), problem);
    if (is(Quirk::DoesNotEnd))
    {
        EXPECT_THROW(trial.planner->solve(questions(500)), EndlessSampling);
        return;
    }
    const ob::PlannerStatus status = trial.planner->solve(questions(500));
    expectTruthful(status, *problem.pdef);
    EXPECT_FALSE(problem.pdef->hasExactSolution());
}

TEST_P(PlannerContract, NamesAnInvalidStart)
{
    const Problem problem = seededProblem(name());
    problem.si->setStateValidityChecker([](const ob::State *) { return false; });
    problem.si->setup();
    const Trial trial = makeTrial(name(), problem);
    const ob::PlannerStatus status = trial.planner->solve(questions(10));
    EXPECT_EQ(status != ob::PlannerStatus::INVALID_START, is(Quirk::InvalidStartNotNamed)) << status.asString();
    EXPECT_FALSE(problem.pdef->hasSolution());
}

void solveWithoutProblem(const std::string &name)
{
    const Problem problem = seededProblem(name);
    const ob::PlannerPtr planner = makePlanner(name, problem.context);
    EXPECT_THROW(planner->solve(questions(10)), ompl::Exception);
    planner->setProblemDefinition(std::make_shared<ob::ProblemDefinition>(problem.si));
    EXPECT_THROW(planner->solve(questions(10)), ompl::Exception);
}

TEST_P(PlannerContract, ThrowsWithoutAProblem)
{
    if (is(Quirk::CrashesWithoutProblem))
        EXPECT_DEATH(solveWithoutProblem(name()), "");
    else
        solveWithoutProblem(name());
}

TEST_P(PlannerContract, ParametersSurviveClear)
{
    const Problem problem = seededProblem(name());
    const bool hasRange = makePlanner(name(), problem.context)->params().hasParam("range");
    const Trial trial = makeTrial(name(), hasRange ? std::map<std::string, std::string>{{"range", "0.75"}}
                                                   : std::map<std::string, std::string>{});
    std::map<std::string, std::string> before;
    std::map<std::string, std::string> after;
    trial.planner->params().getParams(before);
    if (hasRange)
    {
        EXPECT_EQ(std::stod(before.at("range")), 0.75);
    }
    trial.planner->solve(questions(enoughFor(name())));
    trial.planner->clear();
    trial.planner->params().getParams(after);
    EXPECT_EQ(before, after);
}

TEST_P(PlannerContract, DataMarkStartAndGoal)
{
    if (name() == "anytimepathshortening")
        GTEST_SKIP() << "its data are those of one of its planners, whichever state that is in";
    const Trial trial = makeTrial(name());
    trial.planner->solve(questions(enoughFor(name())));
    ob::PlannerData data(trial.problem.si);
    trial.planner->getPlannerData(data);
    EXPECT_GE(data.numVertices(), 2U);
    EXPECT_EQ(data.numStartVertices() == 0, is(Quirk::StartNotMarked));
    if (!is(Quirk::NeverExact))
    {
        EXPECT_EQ(data.numGoalVertices() == 0, is(Quirk::GoalNotMarked));
    }
}

TEST_P(PlannerContract, SameSeedSamePath)
{
    if (findPlanner(name()).threaded)
        GTEST_SKIP() << "plans with threads";
    if (is(Quirk::Unrepeatable))
        GTEST_SKIP() << "reads memory that it has not set";
    const auto solve = [this]
    {
        Trial trial = makeTrial(name());
        trial.planner->solve(questions(enoughFor(name())));
        return trial;
    };
    const Trial first = solve();
    const Trial second = solve();
    EXPECT_EQ(first.problem.counts->stateChecks, second.problem.counts->stateChecks);
    EXPECT_EQ(first.problem.counts->motionChecks, second.problem.counts->motionChecks);
    ASSERT_EQ(first.path().getStateCount(), second.path().getStateCount());
    for (unsigned int i = 0; i < first.path().getStateCount(); ++i)
        EXPECT_TRUE(first.problem.si->equalStates(first.path().getState(i), second.path().getState(i))) << i;
}

bool isSupported(const PlannerEntry &entry)
{
    return whyUnsupported(entry.name, seededProblem(entry.name).context).empty();
}

std::vector<std::string> supportedPlanners()
{
    std::vector<std::string> names;
    for (const PlannerEntry &entry : planners())
        if (isSupported(entry))
            names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, PlannerContract, testing::ValuesIn(supportedPlanners()),
                         [](const auto &planner) { return planner.param; });

TEST(UnsupportedPlanners, LazyLbtrrtAborts)
{
    EXPECT_FALSE(isSupported(findPlanner("lazylbtrrt")));
    if (isOmpl2)
        GTEST_SKIP() << "not seen in OMPL 2";
    EXPECT_DEATH(
        {
            const Problem problem = seededProblem();
            const ob::PlannerPtr planner = findPlanner("lazylbtrrt").make(problem.context);  // makePlanner() refuses
            planner->setProblemDefinition(problem.pdef);
            planner->setup();
            planner->solve(questions(20'000));
        },
        "LPAstarOnGraph");
}
}  // namespace
}  // namespace narrows
