// SPDX-License-Identifier: BSD-3-Clause
// Limits that are no times: what a run may check, the same on any machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "RunSpecs.h"
#include "benchmark/RunOnce.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
/// A scene that no planner solves with so few checks.
RunSpec limitedRun(const std::string &planner)
{
    static const auto scenario =
        std::make_shared<const Scenario>(readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/hppm_case3.yaml"));
    RunSpec spec = smallRun(planner, 5);
    spec.scenario = scenario;
    spec.instance = scenario->name;
    spec.timeLimit = 60.0;  // of CPU time; never reached
    return spec;
}

TEST(RunBudget, EndsByStateChecksWithinOneRoundOfThePlanner)
{
    RunSpec spec = limitedRun("est");  // asks about states; many others ask about motions only
    spec.stateCheckLimit = 300;
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Timeout);
    EXPECT_EQ(record.reason, "state_check_limit");
    EXPECT_GE(*record.stateChecks, 300);
    EXPECT_LE(*record.stateChecks, 310);  // its sampler tries ten at a time
}

TEST(RunBudget, EndsByEvaluations)
{
    RunSpec spec = limitedRun("rrt");
    spec.evaluationLimit = 2000;
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Timeout);
    EXPECT_EQ(record.reason, "evaluation_limit");
    EXPECT_GE(*record.evaluations, 2000);
}

TEST(RunBudget, CountsAHomotopysEvaluations)
{
    RunSpec spec = limitedRun("hppm");
    spec.recipe = false;
    spec.evaluationLimit = 100;  // before the first trace of the search has ended
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Timeout) << record.reason;
    EXPECT_EQ(record.reason, "evaluation_limit");
    EXPECT_GE(*record.evaluations, 100);
}

TEST(RunBudget, ALimitThatIsNotReachedChangesNothing)
{
    RunSpec spec = smallRun("rrtconnect", 3);
    const nlohmann::json free = repeatable(spec, runOnce(spec));
    spec.stateCheckLimit = spec.evaluationLimit = 1'000'000'000;
    EXPECT_EQ(repeatable(spec, runOnce(spec)), free);
}

/// The time that a machine takes decides nothing: planners without threads repeat themselves to the last bit.
class BudgetedPlanner : public testing::TestWithParam<const char *>
{
};

TEST_P(BudgetedPlanner, RepeatsItself)
{
    RunSpec spec = limitedRun(GetParam());
    spec.recipe = false;
    spec.stateCheckLimit = 200;
    spec.evaluationLimit = 2000;
    ASSERT_FALSE(findPlanner(spec.planner).threaded);
    const Record first = runOnce(spec);
    EXPECT_TRUE(first.outcome == Outcome::Solved || first.outcome == Outcome::Timeout) << first.reason;
    const bool limited = first.reason == "state_check_limit" || first.reason == "evaluation_limit";
    EXPECT_EQ(limited, first.outcome == Outcome::Timeout) << first.reason;
    EXPECT_EQ(repeatable(spec, first), repeatable(spec, runOnce(spec)));
}

INSTANTIATE_TEST_SUITE_P(OmplAndOurs, BudgetedPlanner,
                         testing::Values("rrt", "rrtconnect", "est", "sbl", "kpiece1", "bkpiece1", "pdst", "stride",
                                         "trrt", "biest", "hppm", "threader"),
                         [](const auto &test) { return std::string(test.param); });
}  // namespace
}  // namespace narrows
