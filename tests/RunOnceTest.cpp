// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/RunOnce.h"

#include <gtest/gtest.h>

#include "FaultPlanners.h"
#include "RunSpecs.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
TEST(RunOnce, SolvesVerifiesAndMeasures)
{
    RunSpec spec = smallRun("rrtconnect", 3);
    spec.simplify = true;
    const Record record = runOnce(spec);
    ASSERT_EQ(record.outcome, Outcome::Solved) << record.reason;
    EXPECT_EQ(record.verified, true);
    EXPECT_EQ(record.reason, "");
    EXPECT_FALSE(record.usesModel);
    EXPECT_FALSE(record.prescribed);
    ASSERT_GE(record.path.size(), 2u);
    EXPECT_EQ(record.waypoints, static_cast<std::int64_t>(record.path.size()));
    EXPECT_TRUE(record.path.front().isApprox(spec.scenario->planar().task.start));
    EXPECT_GT(record.clearance.value(), 0.0);
    EXPECT_GT(record.length.value(), 0.0);
    EXPECT_GT(record.stateChecks.value() + record.motionChecks.value(), 0);
    EXPECT_GE(record.evaluations.value(), record.motionChecks.value());
    EXPECT_GE(record.graphStates.value(), *record.waypoints);
    EXPECT_LE(record.simplifiedLength.value(), *record.length * (1.0 + 1e-9));
    EXPECT_EQ(record.simplifiedVerified, true);
    EXPECT_TRUE(record.time && record.cpuTime && record.simplificationTime && record.peakMemoryKb);
    EXPECT_TRUE(record.parameters.count("range"));
}

TEST(RunOnce, UnderLimitsASolutionHasADuration)
{
    RunSpec spec = smallRun("rrtconnect", 3);
    EXPECT_FALSE(runOnce(spec).duration);
    spec.limits = MotionLimits{1.5, 4.0, 20.0};
    const Record record = runOnce(spec);
    ASSERT_EQ(record.outcome, Outcome::Solved) << record.reason;
    EXPECT_LE(record.duration.value(), record.stopDuration.value());
    EXPECT_LE(record.peakVelocity.value(), 1.5 * (1.0 + 1e-8));
    EXPECT_LE(record.peakAcceleration.value(), 4.0 * (1.0 + 1e-8));
    EXPECT_LE(record.peakJerk.value(), 20.0 * (1.0 + 1e-8));
    // No joint can turn faster than its limit lets it.
    EXPECT_GE(*record.duration, (record.path.back() - record.path.front()).cwiseAbs().maxCoeff() / 1.5);
    // Twice the velocity, four times the acceleration, eight times the jerk: half the time.
    spec.limits = MotionLimits{3.0, 16.0, 160.0};
    EXPECT_NEAR(runOnce(spec).stopDuration.value(), 0.5 * *record.stopDuration, 1e-12);
}

TEST(RunOnce, StagesComeInOrder)
{
    RunSpec spec = smallRun("rrtconnect");
    spec.warmUp = 0.01;
    std::vector<RunStage> stages;
    runOnce(spec, [&stages](RunStage stage) { stages.push_back(stage); });
    EXPECT_EQ(stages,
              (std::vector<RunStage>{RunStage::WarmUp, RunStage::Building, RunStage::Solving, RunStage::Judging}));
}

TEST(RunOnce, TheSameSpecGivesTheSameRecord)
{
    for (const char *planner : {"rrtconnect", "bkpiece1"})
    {
        RunSpec spec = smallRun(planner, 11);
        spec.simplify = true;
        const nlohmann::json first = repeatable(spec, runOnce(spec));
        runOnce(smallRun(planner, 12));
        EXPECT_EQ(repeatable(spec, runOnce(spec)), first) << planner;
        spec.warmUp = 0.01;
        EXPECT_EQ(repeatable(spec, runOnce(spec)), first) << planner << ", after a warm-up";
    }
}

TEST(RunOnce, SeedsMakeDifferentRuns)
{
    const Record one = runOnce(smallRun("rrtconnect", 1));
    const Record two = runOnce(smallRun("rrtconnect", 2));
    EXPECT_NE(one.length, two.length);
}

TEST(RunOnce, ASeedOfZeroIsASeed)
{
    const RunSpec spec = smallRun("rrtconnect", 0);
    EXPECT_EQ(repeatable(spec, runOnce(spec)), repeatable(spec, runOnce(spec)));
}

TEST(RunOnce, OptimisingPlannersStopAtTheirFirstSolution)
{
    RunSpec spec = smallRun("rrtstar", 5);
    spec.timeLimit = 60.0;
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Solved) << record.reason;
    EXPECT_LT(record.time.value(), spec.timeLimit);
}

TEST(RunOnce, MistakesOfTheCallerAreThrown)
{
    EXPECT_THROW(runOnce(smallRun("no_such_planner")), std::invalid_argument);

    RunSpec unknown = smallRun("rrtconnect");
    unknown.parameters["no_such_parameter"] = "1";
    EXPECT_THROW(runOnce(unknown), ParameterError);

    RunSpec refused = smallRun("rrtconnect");
    refused.parameters["range"] = "wide";
    EXPECT_THROW(runOnce(refused), ParameterError);

    RunSpec checker = smallRun("rrtconnect");
    checker.problem.checker = "crystal_ball";
    EXPECT_THROW(runOnce(checker), std::invalid_argument);
}

TEST(RunOnce, UnsupportedProblemsAreNamedNotTried)
{
    PlannerEntry entry;
    entry.name = "picky";
    entry.make = [](const PlannerContext &) -> ob::PlannerPtr
    {
        throw std::logic_error("was made");
    };
    entry.unsupported = [](const PlannerContext &)
    {
        return "does not like arms";
    };
    registerPlanner(entry);
    const Record record = runOnce(smallRun("picky"));
    EXPECT_EQ(record.outcome, Outcome::Unsupported);
    EXPECT_EQ(record.reason, "does not like arms");
    EXPECT_FALSE(record.time);
}

/// A planner that only remembers its parameter.
class Recipe : public ob::Planner
{
public:
    explicit Recipe(const ob::SpaceInformationPtr &si) : ob::Planner(si, "Recipe")
    {
        const auto declare = [this](const char *name, int Recipe::*value)
        {
            params_.declareParam<int>(
                name, [this, value](int given) { this->*value = given; }, [this, value] { return this->*value; });
        };
        declare("salt", &Recipe::salt_);
        declare("sugar", &Recipe::sugar_);
    }

    using ob::Planner::solve;
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &) override { return ob::PlannerStatus::ABORT; }

private:
    int salt_ = 0;
    int sugar_ = 0;
};

TEST(RunOnce, TheScenariosRecipeIsUsedOnlyWherePermittedAndUnderTheExperimentsWord)
{
    PlannerEntry entry;
    entry.name = "recipe";
    entry.usesModel = true;
    entry.make = [](const PlannerContext &context)
    {
        return std::make_shared<Recipe>(context.si);
    };
    registerPlanner(entry);
    RunSpec spec = smallRun("recipe");
    Scenario scenario = *spec.scenario;
    scenario.methods["recipe"] = {{"salt", "3"}, {"sugar", "4"}};
    spec.scenario = std::make_shared<const Scenario>(scenario);
    spec.parameters["sugar"] = "5";

    const Record with = runOnce(spec);
    EXPECT_TRUE(with.prescribed);
    EXPECT_TRUE(with.usesModel);
    EXPECT_EQ(with.parameters, (std::map<std::string, std::string>{{"salt", "3"}, {"sugar", "5"}}));
    EXPECT_EQ(with.outcome, Outcome::NoSolution);
    EXPECT_EQ(with.reason, "abort");

    spec.recipe = false;
    const Record without = runOnce(spec);
    EXPECT_FALSE(without.prescribed);
    EXPECT_EQ(without.parameters, (std::map<std::string, std::string>{{"salt", "0"}, {"sugar", "5"}}));
}

TEST(RunOnce, ExceptionsAndLiesOfPlannersBecomeOutcomes)
{
    for (const Fault &fault : faultPlanners())
        for (const char *harmless :
             {"fault_logic_error", "fault_int", "fault_collides", "fault_nan", "fault_empty_path", "fault_no_path"})
            if (fault.planner == harmless)
            {
                const Record record = runOnce(smallRun(fault.planner));
                EXPECT_EQ(toString(record.outcome), toString(fault.outcome)) << fault.planner << ": " << record.reason;
                EXPECT_NE(record.reason.find(fault.reason), std::string::npos)
                    << fault.planner << ": " << record.reason;
            }
}

TEST(RunOnce, ALimitThatIsReachedIsATimeout)
{
    RunSpec spec = smallRun("rrt", 1);
    spec.timeLimit = 1e-6;
    const Record record = runOnce(spec);
    EXPECT_EQ(record.outcome, Outcome::Timeout) << record.reason;
    EXPECT_FALSE(record.verified);
    EXPECT_TRUE(record.time);
}
}  // namespace
}  // namespace narrows
