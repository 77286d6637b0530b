// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ViaPointHomotopy.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include "TinyProblem.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"
#include "spaces/PlanarArmStateSpace.h"
#include "validity/TrajectoryVerdict.h"

namespace narrows
{
namespace
{
struct Outcome
{
    Problem problem;
    std::shared_ptr<ViaPointHomotopy> planner;
    ob::PlannerStatus status;

    const og::PathGeometric &path() const { return *problem.pdef->getSolutionPath()->as<og::PathGeometric>(); }
};

Outcome solve(const Scenario &scenario, unsigned seed, const std::map<std::string, std::string> &parameters = {})
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seed);
    Outcome outcome{makeProblem(scenario), nullptr, ob::PlannerStatus::UNKNOWN};
    const ob::PlannerPtr planner = makePlanner("viapoint", outcome.problem.context, parameters);
    outcome.planner = std::dynamic_pointer_cast<ViaPointHomotopy>(planner);
    planner->setProblemDefinition(outcome.problem.pdef);
    planner->setup();
    long questions = 0;
    outcome.status = planner->solve(ob::PlannerTerminationCondition([&questions] { return ++questions > 20'000; }));
    return outcome;
}

std::vector<MotionLimits> defaultLimits(std::size_t joints)
{
    return std::vector<MotionLimits>(joints, {1.5, 4.0, 20.0});
}

/// A chain that bends from hanging down to the left to standing up, past a disc.
Scenario chainScenario(int links)
{
    Scenario scenario;
    std::vector<PlanarLink> chain;
    for (int i = 0; i < links; ++i)
        chain.push_back({2.0 / links, i - 1});
    scenario.name = "chain";
    scenario.planar().model = std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0.0, 0.0}, chain, 0.01), {{"disc", Circle{{1.4, 0.2}, 0.3}}}});
    scenario.planar().task.start = Eigen::VectorXd::Constant(links, -0.8);
    scenario.planar().task.goal = Eigen::VectorXd(Eigen::VectorXd::Constant(links, 1.1));
    scenario.planar().task.limits.convention = AngleConvention::Relative;
    scenario.planar().task.limits.angles.assign(static_cast<std::size_t>(links), Interval{-2.9, 2.9});
    scenario.planar().convention = AngleConvention::Relative;
    return scenario;
}

bool isBlended(const Outcome &outcome)
{
    const auto found = outcome.planner->measures().find("blended");
    return found != outcome.planner->measures().end() && found->second > 0.0;
}

/// Path and motion are free and within limits, by the verifier; the motion is no longer than with stops. Motions with
/// stops follow the path's polyline.
void expectProven(const Scenario &scenario, const Outcome &outcome)
{
    ASSERT_EQ(outcome.status, ob::PlannerStatus::EXACT_SOLUTION);
    const PlanarWorld &world = scenario.planar();
    const Verdict verdict = verify(*world.model, world.task, outcome.problem.space->unwrap(outcome.path()));
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    ASSERT_NE(outcome.planner->trajectory(), nullptr);
    const JointTrajectory &motion = *outcome.planner->trajectory();
    if (isBlended(outcome))
    {
        const TrajectoryVerdict driven = verifyTrajectory(*world.model, world.task, *outcome.problem.space, motion);
        EXPECT_TRUE(driven.accepted) << driven.chords.reason << " at " << driven.chords.segment;
    }
    const auto limits = defaultLimits(static_cast<std::size_t>(motion.joints()));
    EXPECT_LE(stretchFor(trajectoryPeaks(motion), limits).factor, 1.0 + 2e-9);
    const double stops = sevenPhaseStops(outcome.planner->vias(), limits).value->duration();
    EXPECT_LE(motion.duration(), stops * (1.0 + 1e-8));
}

TEST(ViaPointHomotopy, EveryMotionIsProvenWhateverTheSeed)
{
    int blended = 0;
    for (unsigned seed = 1; seed <= 15; ++seed)
        for (const Scenario &scenario : {tinyScenario(), chainScenario(5)})
        {
            const Outcome outcome = solve(scenario, seed, {{"margin", "0.001"}});
            expectProven(scenario, outcome);
            blended += isBlended(outcome) ? 1 : 0;
        }
    EXPECT_GE(blended, 25);
}

TEST(ViaPointHomotopy, TheStraightMotionComesFirst)
{
    Scenario scenario = chainScenario(3);
    scenario.planar().model = std::make_shared<PlanarModel>(PlanarModel{scenario.planar().model->arm, {}});
    const Outcome outcome = solve(scenario, 1);
    ASSERT_EQ(outcome.status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(outcome.planner->measures().at("stage"), 0.0);
    EXPECT_EQ(outcome.path().getStateCount(), 2u);
    EXPECT_EQ(outcome.problem.counts->motionChecks, 1u);
    // Only the first relative joint moves, by 1.9 in all: the fastest move there is.
    EXPECT_NEAR(outcome.planner->trajectory()->duration(), fastestMove(1.9, {1.5, 4.0, 20.0}).duration(), 1e-7);
}

TEST(ViaPointHomotopy, PolylineModeStopsAtItsVias)
{
    const Scenario scenario = chainScenario(3);
    const Outcome outcome = solve(scenario, 3, {{"mode", "polyline"}});
    expectProven(scenario, outcome);
    EXPECT_EQ(outcome.path().getStateCount(), static_cast<std::size_t>(outcome.planner->vias().cols()));
    const double stops = sevenPhaseStops(outcome.planner->vias(), defaultLimits(3)).value->duration();
    EXPECT_NEAR(outcome.planner->trajectory()->duration(), stops, 1e-9);
    EXPECT_LT(solve(scenario, 3).planner->trajectory()->duration(), stops);
}

TEST(ViaPointHomotopy, KeepsTheMarginWhereTheMotionIsSmooth)
{
    const Scenario scenario = chainScenario(4);
    int smooth = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const Outcome outcome = solve(scenario, seed, {{"margin", "0.02"}});
        ASSERT_EQ(outcome.status, ob::PlannerStatus::EXACT_SOLUTION);
        if (!isBlended(outcome))
            continue;
        ++smooth;
        const PlanarWorld &world = scenario.planar();
        const TrajectoryVerdict verdict =
            verifyTrajectory(*world.model, world.task, *outcome.problem.space, *outcome.planner->trajectory());
        // Chords stray from the motion by less than the clearance that is proven for them, which is 1e-4 too small.
        EXPECT_TRUE(verdict.accepted);
        EXPECT_GT(verdict.chords.clearance, 0.009);
    }
    EXPECT_GT(smooth, 2);
}

TEST(ViaPointHomotopy, LimitsMayDifferByJoint)
{
    const Scenario scenario = chainScenario(3);
    const Outcome outcome =
        solve(scenario, 1, {{"velocity", "0.5, 2, 2"}, {"acceleration", "3"}, {"jerk", "10, 20, 30"}});
    ASSERT_EQ(outcome.status, ob::PlannerStatus::EXACT_SOLUTION);
    const std::vector<MotionLimits> limits{{0.5, 3.0, 10.0}, {2.0, 3.0, 20.0}, {2.0, 3.0, 30.0}};
    const double factor = stretchFor(trajectoryPeaks(*outcome.planner->trajectory()), limits).factor;
    EXPECT_NEAR(factor, 1.0, 1e-6);
}

TEST(ViaPointHomotopy, OneJointOrForty)
{
    for (const int links : {1, 40})
    {
        Scenario scenario = chainScenario(links);
        // From -0.8 up to just below the disc: one link cannot get past it.
        if (links == 1)
            scenario.planar().task.goal = Eigen::VectorXd(Eigen::VectorXd::Constant(1, -0.2));
        expectProven(scenario, solve(scenario, 2, {{"evaluations", "50"}, {"margin", "0.005"}}));
    }
}

TEST(ViaPointHomotopy, EqualEndsNeedNoMotion)
{
    Scenario scenario = chainScenario(3);
    scenario.planar().task.goal = scenario.planar().task.start;
    const Outcome outcome = solve(scenario, 1);
    EXPECT_EQ(outcome.status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(outcome.planner->trajectory(), nullptr);
    EXPECT_TRUE(verify(*scenario.planar().model, scenario.planar().task, outcome.problem.space->unwrap(outcome.path()))
                    .accepted);
}

TEST(ViaPointHomotopy, RefusesParametersByName)
{
    const Problem problem = makeProblem(chainScenario(3));
    const auto refused = [&problem](const std::string &name, const std::string &value)
    {
        EXPECT_THROW(makePlanner("viapoint", problem.context, {{name, value}}), ParameterError) << name << value;
    };
    for (const char *limit : {"velocity", "acceleration", "jerk"})
        for (const char *bad : {"0", "-1", "inf", "nan", "1, 2", "1, 2, 0", "fast", ""})
            refused(limit, bad);
    refused("mode", "fast");
    refused("evaluations", "-1");
    refused("margin", "-0.1");
    refused("via_attempts", "-1");
    refused("range", "-1");
}

TEST(ViaPointHomotopy, ClearForgetsTheTrajectory)
{
    const Outcome outcome = solve(chainScenario(3), 1);
    ASSERT_NE(outcome.planner->trajectory(), nullptr);
    outcome.planner->clear();
    EXPECT_EQ(outcome.planner->trajectory(), nullptr);
    EXPECT_EQ(outcome.planner->vias().size(), 0);
    EXPECT_TRUE(outcome.planner->measures().empty());
}
}  // namespace
}  // namespace narrows
