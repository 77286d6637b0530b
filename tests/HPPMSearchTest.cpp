// SPDX-License-Identifier: BSD-3-Clause
// HPPM's search for a homotopy of its own: no recipe, no knowledge of the scenario.
#include <cmath>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "PlannerAttempt.h"
#include "planners/HPPM.h"

namespace narrows
{
namespace
{
using Parameters = std::map<std::string, std::string>;

using Attempt = PlannerAttempt<HPPM>;

Attempt solve(const Scenario &scenario, std::uint32_t seed, const Parameters &parameters = {})
{
    return attempt<HPPM>("hppm", scenario, seed, parameters);
}

/// Case 1 with circles so large that the goal is only `clearance` away from both.
Scenario corridor(double clearance)
{
    Scenario scenario = paperCase(1);
    PlanarModel model = *scenario.planar().model;
    for (PlanarObstacle &obstacle : model.obstacles)
    {
        Circle &circle = std::get<Circle>(obstacle.shape);
        circle.radius = 0.45 * std::sqrt(2.0) - clearance;
    }
    scenario.planar().model = std::make_shared<PlanarModel>(model);
    scenario.methods.clear();
    return scenario;
}

class Corridor : public testing::TestWithParam<double>
{
};

TEST_P(Corridor, IsSolvedByEverySeed)
{
    const Scenario scenario = corridor(GetParam());
    for (std::uint32_t seed = 1; seed <= 10; ++seed)
    {
        const Attempt attempt = solve(scenario, seed, {{"tries", "2000"}});
        ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << "seed " << seed;
        EXPECT_TRUE(verify(scenario.world, attempt.path).accepted) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Closing, Corridor, testing::Values(0.0564, 4e-4, 1e-7));

// One curve in a plane of joint space gets out of a throat because the links in it are held.
TEST(HPPMSearch, ThreadsGapsAHundredThousandthWide)
{
    int held = 0;
    for (const std::string name : {"slab", "slab_generic", "tube", "tube_generic"})
        for (const std::string seed : {"1", "2", "3"})
        {
            const Scenario scenario = readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + name + ".yaml",
                                                   {{"links", "6"}, {"half_width", "1e-5"}, {"seed", seed}});
            const Attempt attempt = solve(scenario, 1, {{"tries", "3000"}});
            ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << name << " " << seed;
            EXPECT_TRUE(verify(scenario.world, attempt.path).accepted) << name << " " << seed;
            held += attempt.planner->recipe().count("held") > 0 ? 1 : 0;
        }
    EXPECT_GE(held, 10);  // of 12; without, hardly any of these is solved
}

TEST(HPPMSearch, ItsRecipeFindsTheSamePathAtOnce)
{
    const Scenario scenario = corridor(4e-4);
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
    {
        const Attempt found = solve(scenario, seed);
        ASSERT_FALSE(found.planner->recipe().empty());
        Parameters recipe = found.planner->recipe();
        const Attempt replayed = solve(scenario, seed + 100, recipe);
        ASSERT_EQ(replayed.status, ob::PlannerStatus::EXACT_SOLUTION) << replayed.planner->reason();
        EXPECT_LE(replayed.planner->measures().at("traces"), 2.0);
        EXPECT_EQ(replayed.path, found.path);
    }
}

TEST(HPPMSearch, SameSeedSamePath)
{
    const Scenario scenario = corridor(0.01);
    const Attempt first = solve(scenario, 7), second = solve(scenario, 7), other = solve(scenario, 8);
    EXPECT_EQ(first.path, second.path);
    EXPECT_EQ(first.planner->measures(), second.planner->measures());
    EXPECT_NE(first.path, other.path);
}

TEST(HPPMSearch, GoesStraightWhereItCan)
{
    Scenario scenario = corridor(0.05);
    PlanarModel model = *scenario.planar().model;
    model.obstacles.clear();
    scenario.planar().model = std::make_shared<PlanarModel>(model);
    const Attempt attempt = solve(scenario, 1);
    EXPECT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(attempt.path.size(), 2u);
    EXPECT_TRUE(attempt.planner->recipe().empty());
}

TEST(HPPMSearch, GivesUpAfterItsTries)
{
    int gaveUp = 0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed)
    {
        const Attempt attempt = solve(corridor(1e-7), seed, {{"tries", "1"}});
        if (attempt.status == ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++gaveUp;
        EXPECT_EQ(attempt.status, ob::PlannerStatus::ABORT);
        EXPECT_EQ(attempt.planner->reason(), "tries");
        EXPECT_LE(attempt.planner->measures().at("traces"), 2.0);
        EXPECT_EQ(attempt.planner->recipe().at("search"), "paper");  // of the curve that was tried last
    }
    EXPECT_GT(gaveUp, 0);
}

TEST(HPPMSearch, ReachesTips)
{
    Scenario scenario = corridor(0.03);
    scenario.planar().task.goal = TipGoal{2, {2.5, 3.5}, 1e-3};
    const Attempt attempt = solve(scenario, 3);
    ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(verify(scenario.world, attempt.path).accepted);
}

TEST(HPPMSearch, KeepsToJointLimits)
{
    Scenario scenario = corridor(0.02);
    PlanarTask &task = scenario.planar().task;
    task.limits.convention = AngleConvention::Absolute;
    task.limits.angles = {Interval{-1.2, 2.2}, Interval{-1.5, 1.9}, Interval{-1.7, 2.3}};
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
    {
        const Attempt attempt = solve(scenario, seed, {{"tries", "3000"}});
        ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << "seed " << seed;
        EXPECT_TRUE(verify(scenario.world, attempt.path).accepted);
    }
}
}  // namespace
}  // namespace narrows
