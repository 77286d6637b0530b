// SPDX-License-Identifier: BSD-3-Clause
// What Threader does on request: polishing, and centred steps with parts of them off.
#include <gtest/gtest.h>

#include "PaperCases.h"
#include "PlannerAttempt.h"
#include "planners/Threader.h"

namespace narrows
{
namespace
{
using Attempt = PlannerAttempt<Threader>;

Attempt solve(const Scenario &scenario, const std::map<std::string, std::string> &parameters, std::uint32_t seed = 2)
{
    Attempt result = attempt<Threader>("threader", scenario, seed, parameters, {"analytic", "continuous", "absolute"});
    EXPECT_EQ(result.status, ob::PlannerStatus::EXACT_SOLUTION) << result.planner->reason();
    return result;
}

double lengthOf(const Attempt &attempt)
{
    return attempt.problem.pdef->getSolutionPath()->length();
}

TEST(ThreaderPolish, ShortensOrKeepsAwayAndStaysProven)
{
    const Scenario scenario = paperCase(1);
    const Attempt plain = solve(scenario, {}), shorter = solve(scenario, {{"polish", "length"}}),
                  further = solve(scenario, {{"polish", "clearance"}, {"clearance", "0.02"}});
    const Verdict close = verify(scenario.world, shorter.path), far = verify(scenario.world, further.path);
    ASSERT_TRUE(close.accepted && far.accepted);
    EXPECT_LT(lengthOf(shorter), 0.8 * lengthOf(plain));
    EXPECT_LT(lengthOf(further), lengthOf(plain));
    EXPECT_LT(close.clearance, 1e-3);
    EXPECT_GT(far.clearance, 0.04);
    EXPECT_GT(further.measure("band_moves"), 0.0);
    EXPECT_EQ(plain.planner->measures().count("band_moves"), 0U);
}

TEST(ThreaderPolish, PolishesWhateverMemberSolved)
{
    const Scenario scenario = paperCase(1);
    const std::map<std::string, std::string> curves{{"full", "0"}, {"slices", "0"}, {"cells", "0"}, {"straight", "0"}};
    auto polished = curves;
    polished["polish"] = "length";
    const Attempt plain = solve(scenario, curves), shorter = solve(scenario, polished);
    EXPECT_EQ(shorter.measure("solved_by_traces"), 1.0);
    EXPECT_TRUE(verify(scenario.world, shorter.path).accepted);
    EXPECT_LT(lengthOf(shorter), lengthOf(plain));
}

TEST(ThreaderPolish, IsTheSameEveryTime)
{
    const Scenario scenario = paperCase(3);
    const Attempt one = solve(scenario, {{"polish", "length"}}), two = solve(scenario, {{"polish", "length"}});
    ASSERT_EQ(one.path.size(), two.path.size());
    for (std::size_t i = 0; i < one.path.size(); ++i)
        EXPECT_EQ(one.path[i], two.path[i]);
}

TEST(ThreaderPolish, RefusesWhatItDoesNotKnow)
{
    const Attempt solved = solve(paperCase(1), {});
    Threader &planner = *solved.planner;
    EXPECT_THROW(planner.setPolish("shorter"), std::invalid_argument);
    EXPECT_THROW(planner.setClearance(-0.1), std::invalid_argument);
    EXPECT_THROW(planner.setSquare(1.1), std::invalid_argument);
    EXPECT_THROW(planner.setNarrow(-0.1), std::invalid_argument);
    EXPECT_THROW(planner.setLengthening(2.1), std::invalid_argument);
}

// Without trees' luck with curves: at a half width of 1e-5 the middle alone, or links that are not lengthened, take
// several times the work (`threader_ablation.cfg`). Single scenes differ by more than that: the sum of many counts.
TEST(ThreaderCentring, NeedsItsParts)
{
    double whole = 0.0, middleAlone = 0.0, notLengthened = 0.0;
    for (int scene = 1; scene <= 12; ++scene)
    {
        const Scenario scenario =
            readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/slab_generic.yaml",
                         {{"links", "6"}, {"half_width", "1e-5"}, {"seed", std::to_string(scene)}});
        for (std::uint32_t seed = 1; seed <= 3; ++seed)
        {
            const auto checks = [&](std::map<std::string, std::string> parameters)
            {
                parameters["traces"] = "0";
                const Attempt result = solve(scenario, parameters, seed);
                EXPECT_TRUE(verify(scenario.world, result.path).accepted);
                return static_cast<double>(result.problem.counts->motionChecks);
            };
            whole += checks({});
            middleAlone += checks({{"square", "0"}});
            notLengthened += checks({{"lengthening", "0"}});
        }
    }
    EXPECT_GT(middleAlone, 1.5 * whole);
    EXPECT_GT(notLengthened, 2.0 * whole);
}
}  // namespace
}  // namespace narrows
