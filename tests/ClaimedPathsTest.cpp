// SPDX-License-Identifier: BSD-3-Clause
// Every path that HPPM and Threader claim, judged by the verifier. NARROWS_CLAIMS=100000 in the environment makes it a
// campaign.
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/PlannerFactory.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
struct Claims
{
    int claimed = 0;
    int refused = 0;
    std::string first;  ///< what the verifier said of the first it refused
};

int wantedClaims()
{
    const char *text = std::getenv("NARROWS_CLAIMS");
    return text == nullptr ? 1200 : std::atoi(text);
}

/// With little patience: scenes without a way cost all of it.
struct Claimant
{
    std::string planner;
    std::map<std::string, std::string> parameters;
};

/// Solves once and adds what came of it.
void claim(const Claimant &claimant, const Scenario &scenario, std::uint32_t seed, Claims &claims)
{
    ompl::RNG::setSeed(seed);
    const Problem problem = makeProblem(scenario);
    const ob::PlannerPtr planner = makePlanner(claimant.planner, problem.context, claimant.parameters);
    planner->setProblemDefinition(problem.pdef);
    planner->setup();
    if (planner->solve(ob::plannerNonTerminatingCondition()) != ob::PlannerStatus::EXACT_SOLUTION)
        return;
    const auto &path = *problem.pdef->getSolutionPath()->as<og::PathGeometric>();
    const Verdict verdict = verify(scenario.world, problem.space->unwrap(path));
    ++claims.claimed;
    if (!verdict.accepted && claims.refused++ == 0)
        claims.first = scenario.name + ", seed " + std::to_string(seed) + ": " + verdict.reason;
}

struct Source
{
    const char *file;
    GenerateSettings settings;
};

const std::vector<Source> sources{{"circles", {{"links", "3"}}},
                                  {"circles", {{"links", "6"}}},
                                  {"circles", {{"links", "10"}}},
                                  {"slab_generic", {{"links", "6"}, {"half_width", "1e-2"}}},
                                  {"slab_generic", {{"links", "3"}, {"half_width", "1e-4"}}},
                                  {"slab_generic", {{"links", "12"}, {"half_width", "1e-5"}}},
                                  {"tube_generic", {{"links", "8"}, {"half_width", "1e-3"}}},
                                  {"tube", {{"links", "4"}, {"half_width", "1e-4"}}},
                                  {"bent_tube", {{"links", "8"}, {"half_width", "1e-2"}}},
                                  {"blind", {{"links", "3"}, {"half_width", "1e-2"}}},
                                  {"mixed", {{"links", "6"}}},
                                  {"corridor", {{"clearance", "1e-3"}}},
                                  {"corridor", {{"clearance", "1e-7"}}},
                                  {"spatial_elbow", {}},
                                  {"spatial_six", {}}};

class ClaimedPaths : public testing::TestWithParam<Claimant>
{
};

TEST_P(ClaimedPaths, NoneIsRefused)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const int wanted = wantedClaims();
    Claims claims;
    for (std::uint32_t round = 1; claims.claimed < wanted; ++round)
        for (const Source &source : sources)
        {
            GenerateSettings settings = source.settings;
            const std::string file(source.file);
            if (file.rfind("spatial", 0) != 0 && file != "corridor")
                settings.emplace_back("seed", std::to_string(round));
            const Scenario scenario =
                readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/" + file + ".yaml", settings);
            for (std::uint32_t seed = 1; seed <= 8; ++seed)
                claim(GetParam(), scenario, 1000 * round + seed, claims);
        }
    RecordProperty("claimed", claims.claimed);
    EXPECT_EQ(claims.refused, 0) << claims.first;
    EXPECT_GE(claims.claimed, wanted);
}

INSTANTIATE_TEST_SUITE_P(Planners, ClaimedPaths,
                         testing::Values(Claimant{"hppm", {{"search", "restarts"}, {"tries", "60"}}},
                                         Claimant{"threader", {{"rounds", "3"}}}),
                         [](const auto &claimant) { return claimant.param.planner; });
}  // namespace
}  // namespace narrows
