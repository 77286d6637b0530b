// SPDX-License-Identifier: BSD-3-Clause
// Threader with arms in space: openings of walls and of boxes.
#include <gtest/gtest.h>

#include "PlannerAttempt.h"
#include "planners/Threader.h"

namespace narrows
{
namespace
{
using Attempt = PlannerAttempt<Threader>;

Scenario generated(const std::string &family, const GenerateSettings &settings)
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + family + ".yaml", settings);
}

Attempt solve(const Scenario &scenario, std::uint32_t seed, std::map<std::string, std::string> parameters = {})
{
    parameters.insert({"rounds", "12"});
    return attempt<Threader>("threader", scenario, seed, parameters);
}

void expectSolved(const Scenario &scenario, const Attempt &attempt)
{
    ASSERT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << attempt.planner->reason();
    EXPECT_TRUE(verify(scenario.world, attempt.path).accepted);
}

class Opening : public testing::TestWithParam<std::string>
{
};

// Six joints, a tool that has a ten-thousandth of its length to spare.
TEST_P(Opening, IsThreadedBySixJoints)
{
    double checks = 0.0;
    for (const std::string seed : {"1", "2", "3"})
        for (const std::string width : {"1e-2", "1e-3", "1e-4"})
        {
            const Scenario scenario =
                generated("slot", {{"opening", GetParam()}, {"half_width", width}, {"seed", seed}});
            const Attempt attempt = solve(scenario, 1);
            expectSolved(scenario, attempt);
            checks += static_cast<double>(attempt.problem.counts->motionChecks);
        }
    EXPECT_LT(checks / 9.0, 1000.0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Opening, testing::Values("slot", "hole", "box"));

TEST(ThreaderInSpace, SixteenJointsThreadTwoHoles)
{
    for (const std::string seed : {"1", "2", "3"})
        for (const std::string width : {"1e-1", "1e-3"})
        {
            const Scenario scenario = generated("holes", {{"half_width", width}, {"seed", seed}});
            const Attempt attempt = solve(scenario, 1);
            expectSolved(scenario, attempt);
        }
}

TEST(ThreaderInSpace, OwesItToCentredSteps)
{
    const Scenario scenario = generated("slot", {{"opening", "hole"}, {"half_width", "1e-4"}, {"seed", "1"}});
    EXPECT_GT(solve(scenario, 1).measure("centred_steps"), 0.0);
    const Attempt without = solve(scenario, 1, {{"centring", "0"}, {"traces", "0"}, {"rounds", "3"}});
    EXPECT_EQ(without.status, ob::PlannerStatus::ABORT);
    EXPECT_EQ(without.measure("centred_steps"), 0.0);
}

TEST(ThreaderInSpace, SameSeedSamePath)
{
    const Scenario scenario = generated("holes", {{"half_width", "1e-2"}, {"seed", "2"}});
    const Attempt first = solve(scenario, 7), second = solve(scenario, 7), other = solve(scenario, 8);
    EXPECT_EQ(first.path, second.path);
    EXPECT_EQ(first.planner->measures(), second.planner->measures());
    EXPECT_NE(first.path, other.path);
}

TEST(ThreaderInSpace, ThreadsAMesh)
{
    const Scenario scenario = generated("spatial_mesh", {});
    expectSolved(scenario, solve(scenario, 1));
}
}  // namespace
}  // namespace narrows
