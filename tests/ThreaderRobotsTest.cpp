// SPDX-License-Identifier: BSD-3-Clause
// Threader with what the paper's arms do not have: thick links, limits, slides, grippers, tips as goals, links that
// must keep clear of each other; in the plane and in space.
#include <cmath>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "PlannerAttempt.h"
#include "planners/Threader.h"

namespace narrows
{
namespace
{
using Attempt = PlannerAttempt<Threader>;
using Eigen::Vector2d;
using Eigen::VectorXd;

Attempt solve(const Scenario &scenario, std::uint32_t seed, std::map<std::string, std::string> parameters = {})
{
    parameters.insert({"rounds", "14"});
    return attempt<Threader>("threader", scenario, seed, parameters);
}

void expectSolved(const Scenario &scenario, const Attempt &attempt)
{
    ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << scenario.name << " " << attempt.planner->reason();
    EXPECT_TRUE(verify(scenario.world, attempt.path).accepted) << scenario.name;
}

Scenario scenarioOf(const std::string &file, const GenerateSettings &settings = {})
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + file + ".yaml", settings);
}

/// A gripper on a slide and a chain, on one base and without obstacles. At the goal the chain's last link is between
/// the fingers, which leave it `halfWidth` to both sides and can open but little.
Scenario linkBetweenFingers(double halfWidth)
{
    constexpr double radius = 0.02, spread = 1.0;
    const double opening = 4.0 * radius + 2.0 * halfWidth;
    const double bend = std::asin((0.5 * std::sin(spread) - 0.5 * opening) / 0.4);
    const Vector2d middle(1.0 + 0.5 * std::cos(spread) + 0.4 * std::cos(bend), 0.0), base = middle + Vector2d(0.5, 0.0);
    const double towards = std::atan2(base.y(), base.x()), elbow = std::acos(base.norm() / 3.2);
    PlanarModel model{
        PlanarArm({0, 0}, {{1.0, -1}, {0.5, 0}, {0.5, 0}, {0.4, 1}, {0.4, 2}, {1.6, -1}, {1.6, 5}, {0.8, 6}}, radius),
        {},
        true};
    Scenario scenario = paperCase(1);
    scenario.name = "link between fingers";
    scenario.planar().model = std::make_shared<PlanarModel>(std::move(model));
    PlanarTask &task = scenario.planar().task;
    task.goal = VectorXd{{0.0, spread, -spread, -bend, bend, towards - elbow, towards + elbow, M_PI}};
    task.start = VectorXd{{0.3, 0.3 + spread, 0.3 - spread, 0.3 - bend, 0.3 + bend, -1.2, -1.6, -1.0}};
    scenario.planar().convention = AngleConvention::Relative;
    constexpr double play = 0.02;
    const auto around = [](double angle)
    {
        return Interval{angle - play, angle + play};
    };
    task.limits.convention = AngleConvention::Relative;
    task.limits.angles.assign(8, std::nullopt);
    task.limits.angles[1] = around(spread);
    task.limits.angles[2] = around(-spread);
    task.limits.angles[3] = around(-bend - spread);
    task.limits.angles[4] = around(bend + spread);
    return scenario;
}

TEST(ThreaderRobots, ALinkThreadsTheGapBetweenTwoOthers)
{
    for (const double halfWidth : {1e-2, 1e-3, 1e-4})
        for (std::uint32_t seed = 1; seed <= 3; ++seed)
        {
            const Scenario scenario = linkBetweenFingers(halfWidth);
            const Attempt attempt = solve(scenario, seed);
            expectSolved(scenario, attempt);
            EXPECT_GT(attempt.measure("centred_steps"), 0.0) << halfWidth;
        }
}

// Without them, five runs took 22 times as many motion checks.
TEST(ThreaderRobots, GapsBetweenLinksSpareSamples)
{
    const Scenario scenario = linkBetweenFingers(1e-4);
    const Attempt with = solve(scenario, 1);
    const Attempt without = solve(scenario, 1, {{"centring", "0"}, {"rounds", "10"}});
    EXPECT_LT(static_cast<double>(with.problem.counts->motionChecks),
              0.5 * static_cast<double>(without.problem.counts->motionChecks));
}

TEST(ThreaderRobots, AGripperOnASlideReachesATipWithinItsLimits)
{
    const Scenario scenario = scenarioOf("gripper_slide");
    for (std::uint32_t seed = 1; seed <= 3; ++seed)
        expectSolved(scenario, solve(scenario, seed));
}

TEST(ThreaderRobots, ThickLinksThreadGapsOfTheirOwnWidth)
{
    for (const std::string seed : {"1", "2", "3"})
    {
        Scenario scenario = scenarioOf("slab_generic", {{"links", "6"}, {"half_width", "1e-2"}, {"seed", seed}});
        // Links so thick that a hundredth of the opening is left.
        PlanarModel model = *scenario.planar().model;
        const PlanarArm &thin = model.arm;
        model.arm = PlanarArm(thin.base(), thin.links(), 0.99e-2);
        scenario.planar().model = std::make_shared<PlanarModel>(model);
        const Attempt attempt = solve(scenario, 1);
        expectSolved(scenario, attempt);
        EXPECT_GT(attempt.measure("centred_steps"), 0.0);
    }
}

TEST(ThreaderRobots, LimitsDoNotKeepItFromThreading)
{
    for (const std::string seed : {"1", "2", "3"})
    {
        Scenario scenario = scenarioOf("tube_generic", {{"links", "4"}, {"half_width", "1e-3"}, {"seed", seed}});
        PlanarTask &task = scenario.planar().task;
        task.limits.convention = AngleConvention::Absolute;
        const VectorXd &goal = std::get<VectorXd>(task.goal);
        task.limits.angles.clear();
        for (Eigen::Index joint = 0; joint < goal.size(); ++joint)
            task.limits.angles.push_back(Interval{std::min(goal[joint], task.start[joint]) - 1.5,
                                                  std::max(goal[joint], task.start[joint]) + 1.5});
        expectSolved(scenario, solve(scenario, 1));
    }
}

TEST(ThreaderRobots, ATipGoalBehindASlotInSpace)
{
    for (const std::string opening : {"slot", "hole"})
    {
        Scenario scenario = scenarioOf("slot", {{"opening", opening}, {"half_width", "1e-2"}, {"seed", "1"}});
        SpatialArm::Placement placement;
        const SpatialArm &arm = scenario.spatial().model->arm;
        arm.place(std::get<VectorXd>(scenario.spatial().task.goal), placement);
        scenario.spatial().task.goal = SpatialTipGoal{arm.linkCount() - 1, placement.points.back(), 0.01};
        expectSolved(scenario, solve(scenario, 1));
    }
}
}  // namespace
}  // namespace narrows
