// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "CorridorScene.h"
#include "PaperCases.h"
#include "PlannerAttempt.h"
#include "planners/Threader.h"

namespace narrows
{
namespace
{
using Parameters = std::map<std::string, std::string>;

using Attempt = PlannerAttempt<Threader>;

Attempt solve(const Scenario &scenario, std::uint32_t seed, Parameters parameters = {},
              const ProblemOptions &options = {})
{
    parameters.insert({"rounds", "12"});
    return attempt<Threader>("threader", scenario, seed, parameters, options);
}

void expectSolved(const Scenario &scenario, const Attempt &attempt)
{
    ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << scenario.name << " " << attempt.planner->reason();
    EXPECT_TRUE(verify(scenario.world, attempt.path).accepted) << scenario.name;
}

Scenario generated(const std::string &file, const GenerateSettings &settings)
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + file + ".yaml", settings);
}

class PaperCase : public testing::TestWithParam<int>
{
};

TEST_P(PaperCase, IsSolvedByEverySeedInEverySpace)
{
    const Scenario scenario = paperCase(GetParam());
    for (const std::string space : {"absolute", "relative", "absolute_line"})
        for (std::uint32_t seed = 1; seed <= 5; ++seed)
            expectSolved(scenario, solve(scenario, seed, {}, {"analytic", "continuous", space}));
}

INSTANTIATE_TEST_SUITE_P(All, PaperCase, testing::Values(1, 2, 3));

class Corridor : public testing::TestWithParam<double>
{
};

TEST_P(Corridor, IsSolvedByEverySeed)
{
    Scenario scenario = paperCase(1);
    scenario.planar().model = std::make_shared<PlanarModel>(corridor(GetParam()));
    constexpr int seeds = 10;
    double checks = 0.0;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed)
    {
        const Attempt attempt = solve(scenario, seed);
        expectSolved(scenario, attempt);
        checks += static_cast<double>(attempt.problem.counts->motionChecks);
    }
    // 60 to 320 were measured; thousands where equations count that depend on others.
    EXPECT_LT(checks, 1000.0 * seeds);
}

INSTANTIATE_TEST_SUITE_P(Closing, Corridor, testing::Values(0.0564, 4e-4, 1e-7));

// Half widths down to a millionth, by links that cross the gaps centred; and nothing else would do.
TEST(Threader, ThreadsGapsAMillionthWide)
{
    for (const std::string file : {"slab", "slab_generic", "tube", "tube_generic"})
        for (const std::string width : {"1e-3", "1e-6"})
            for (const std::string seed : {"1", "2", "3"})
            {
                const Scenario scenario = generated(file, {{"links", "8"}, {"half_width", width}, {"seed", seed}});
                const Attempt attempt = solve(scenario, 1);
                expectSolved(scenario, attempt);
                EXPECT_GT(attempt.measure("centred_steps"), 0.0);
            }
}

TEST(Threader, WithoutCentredStepsDoesNot)
{
    const Scenario scenario = generated("slab_generic", {{"links", "6"}, {"half_width", "1e-5"}, {"seed", "1"}});
    const Attempt attempt = solve(scenario, 1, {{"centring", "0"}, {"traces", "0"}, {"rounds", "3"}});
    EXPECT_EQ(attempt.status, ob::PlannerStatus::ABORT);
    EXPECT_EQ(attempt.planner->reason(), "rounds");
    EXPECT_EQ(attempt.measure("centred_steps"), 0.0);
}

TEST(Threader, SameSeedSamePath)
{
    const Scenario scenario = paperCase(3);
    const Attempt first = solve(scenario, 7), second = solve(scenario, 7), other = solve(scenario, 8);
    EXPECT_EQ(first.path, second.path);
    EXPECT_EQ(first.planner->measures(), second.planner->measures());
    EXPECT_NE(first.path, other.path);
}

TEST(Threader, MembersSolveAlone)
{
    const Scenario scenario = paperCase(1);
    const Parameters none{{"full", "0"}, {"slices", "0"}, {"cells", "0"}, {"traces", "0"}};
    for (const auto &[member, measure] : std::map<std::string, std::string>{{"full", "solved_by_full"},
                                                                            {"slices", "solved_by_slice"},
                                                                            {"cells", "solved_by_cells"},
                                                                            {"traces", "solved_by_traces"}})
    {
        Parameters only = none;
        only[member] = "1";
        only["rounds"] = "200";
        const Attempt attempt = solve(scenario, 3, only);
        expectSolved(scenario, attempt);
        EXPECT_EQ(attempt.measure(measure), 1.0) << member;
    }
    const Attempt idle = solve(scenario, 3, none);
    EXPECT_EQ(idle.status, ob::PlannerStatus::ABORT);
    EXPECT_EQ(idle.planner->reason(), "no_member");
}

TEST(Threader, BentStepsSpareSamples)
{
    double with = 0.0, without = 0.0;
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
    {
        with += static_cast<double>(solve(paperCase(3), seed, {{"cells", "0"}}).problem.counts->motionChecks);
        without += static_cast<double>(
            solve(paperCase(3), seed, {{"cells", "0"}, {"bending", "0"}}).problem.counts->motionChecks);
    }
    EXPECT_LT(with, 0.5 * without);
}

// Steps by cells of the tip, of which winding passages without gaps get most.
TEST(Threader, CellsFindTheWayThroughMazes)
{
    double byCells = 0.0;
    for (const std::string seed : {"1", "2", "3", "4", "5"})
    {
        const Scenario scenario = generated("maze", {{"links", "12"}, {"seed", seed}});
        const Attempt attempt = solve(scenario, 1);
        expectSolved(scenario, attempt);
        EXPECT_LT(attempt.problem.counts->motionChecks, 3000u);
        EXPECT_EQ(attempt.measure("centred_steps"), 0.0);
        byCells += attempt.measure("solved_by_cells");
    }
    EXPECT_GE(byCells, 3.0);
}

// In the open it certifies about as many motions as RRT-Connect, and bends nothing; before steps have been blocked it
// looks at the straight motion alone.
TEST(Threader, StartsLean)
{
    double motions = 0.0, rivals = 0.0;
    int lean = 0, looked = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        const Scenario scenario = generated("mixed", {{"links", "6"}, {"seed", std::to_string(seed)}});
        const Attempt attempt = solve(scenario, 1);
        expectSolved(scenario, attempt);
        motions += static_cast<double>(attempt.problem.counts->motionChecks);
        rivals += static_cast<double>(
            narrows::attempt<ompl::geometric::RRTConnect>("rrtconnect", scenario, 1, {{"range", "2"}})
                .problem.counts->motionChecks);
        const bool isLean = attempt.measure("blocked_steps") <= 3.0;
        lean += isLean ? 1 : 0;
        EXPECT_EQ(attempt.measure("bent_steps"), 0.0) << seed;
        const double looks = attempt.measure("looks");
        EXPECT_TRUE(!isLean || looks <= 1.0) << seed;
        looked += looks > 1.0 ? 1 : 0;
    }
    EXPECT_GE(lean, 10);
    EXPECT_GE(looked, 1);
    EXPECT_LT(motions, 1.2 * rivals);
}

// Openings of the maze count as gaps for so long a chain, and some steps go on through them: it winds all the same.
TEST(Threader, LongChainsGoThroughMazesByCells)
{
    double byCells = 0.0, draws = 0.0, samples = 0.0;
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
    {
        const Scenario scenario = generated("maze", {{"links", "20"}, {"seed", "1"}});
        const Attempt attempt = solve(scenario, seed);
        expectSolved(scenario, attempt);
        EXPECT_LT(attempt.problem.counts->motionChecks, 6000u);
        EXPECT_GT(attempt.measure("centred_steps"), 0.0);
        byCells += attempt.measure("solved_by_cells");
        draws += attempt.measure("draws");
        samples += attempt.measure("samples");
    }
    EXPECT_EQ(byCells, 4.0);
    EXPECT_LT(draws, 40.0 * samples);  // of up to 100: links that are free are kept
}

// Where two gaps hold a long chain, one of the curves of the first rounds arrives.
TEST(Threader, FollowsCurvesEarlyWhereGapsAreThreaded)
{
    double byTraces = 0.0;
    for (const std::string seed : {"3", "4", "5"})
    {
        const Scenario scenario = generated("tube_generic", {{"links", "32"}, {"half_width", "1e-3"}, {"seed", seed}});
        const Attempt attempt = solve(scenario, 1, {{"rounds", "2"}});
        expectSolved(scenario, attempt);
        byTraces += attempt.measure("solved_by_traces");
    }
    EXPECT_EQ(byTraces, 3.0);
}

// In the horn trees are near each other after a few samples in slices, which never join them; in case 3 slices get
// their three turns of 120 samples.
TEST(Threader, GivesSlicesUpWhereTreesComeNoNearer)
{
    const Parameters onlySlices{{"full", "0"}, {"cells", "0"}, {"traces", "0"}, {"rounds", "1"}};
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
    {
        const Attempt horn = solve(generated("horn", {{"links", "10"}}), seed, onlySlices);
        EXPECT_NE(horn.status, ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_LT(horn.measure("samples"), 240.0) << seed;
        const Attempt maze = solve(paperCase(3), seed, onlySlices);
        EXPECT_TRUE(maze.measure("samples") == 360.0 || maze.status == ob::PlannerStatus::EXACT_SOLUTION) << seed;
    }
}

// Openings of a maze are gaps too. Without the limit, the slices of this one slide some 800 times in their first turns.
TEST(Threader, LeavesSlicesThatSlideOn)
{
    const Parameters onlySlices{{"full", "0"}, {"cells", "0"}, {"traces", "0"}, {"rounds", "1"}};
    const Attempt maze = solve(generated("maze", {{"links", "20"}, {"seed", "1"}}), 1, onlySlices);
    EXPECT_NE(maze.status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_LT(maze.measure("samples"), 360.0);
    EXPECT_GT(maze.measure("centred_steps") + maze.measure("refused_centred_steps"), 3.0 * 18.0);
    EXPECT_LT(maze.measure("centred_steps") + maze.measure("refused_centred_steps"), 300.0);
}

TEST(Threader, DoesNotBendLongSteps)
{
    const Parameters lone{{"cells", "0"}, {"traces", "0"}, {"rounds", "1"}};
    for (std::uint32_t seed = 1; seed <= 3; ++seed)
    {
        Parameters full = lone, slices = lone;
        full["slices"] = "0";  // 48 samples, all of long steps
        slices["full"] = "0";
        EXPECT_EQ(solve(paperCase(3), seed, full).measure("bent_steps"), 0.0) << seed;
        EXPECT_GT(solve(paperCase(3), seed, slices).measure("bent_steps"), 0.0) << seed;
    }
}

TEST(Threader, GoesStraightWhereItCan)
{
    Scenario scenario = paperCase(1);
    PlanarModel model = *scenario.planar().model;
    model.obstacles.clear();
    scenario.planar().model = std::make_shared<PlanarModel>(model);
    const Attempt attempt = solve(scenario, 1);
    expectSolved(scenario, attempt);
    EXPECT_EQ(attempt.path.size(), 2u);
    EXPECT_EQ(attempt.measure("samples"), 0.0);
    EXPECT_EQ(attempt.measure("solved_by_straight"), 1.0);
}

TEST(Threader, ReachesTips)
{
    Scenario scenario = paperCase(1);
    scenario.planar().task.goal = TipGoal{2, {2.5, 3.5}, 1e-3};
    expectSolved(scenario, solve(scenario, 3));
}

TEST(Threader, KeepsToJointLimits)
{
    Scenario scenario = paperCase(1);
    PlanarTask &task = scenario.planar().task;
    task.limits.convention = AngleConvention::Absolute;
    task.limits.angles = {Interval{-1.2, 2.2}, Interval{-1.5, 1.9}, Interval{-1.7, 2.3}};
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
        expectSolved(scenario, solve(scenario, seed));
}

TEST(Threader, PlansInSpace)
{
    for (const std::string file : {"spatial_elbow", "spatial_six"})
    {
        const Scenario scenario = readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + file + ".yaml");
        expectSolved(scenario, solve(scenario, 1));
    }
}

TEST(Threader, RefusesImpossibleParameters)
{
    const Problem problem = makeProblem(paperCase(1));
    for (const auto &[name, value] : std::map<std::string, std::string>{{"range", "-1"},
                                                                        {"slice_range", "101"},
                                                                        {"slice_box", "0"},
                                                                        {"slice_dimensions", "0"},
                                                                        {"gap_width", "0"},
                                                                        {"rounds", "0"}})
        EXPECT_THROW(makePlanner("threader", problem.context, {{name, value}}), ParameterError) << name;
}
}  // namespace
}  // namespace narrows
