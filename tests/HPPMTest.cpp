// SPDX-License-Identifier: BSD-3-Clause
#include "planners/HPPM.h"

#include <cmath>

#include <gtest/gtest.h>
#include <ompl/base/PlannerTerminationCondition.h>

#include "PaperCases.h"
#include "planners/PlannerFactory.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
using Parameters = std::map<std::string, std::string>;

struct Attempt
{
    Scenario scenario;
    Problem problem;
    ob::PlannerPtr planner;
    ob::PlannerStatus status;

    const HPPM &hppm() const { return dynamic_cast<const HPPM &>(*planner); }
};

/// Solves with the scenario's recipe and `changes` to it; an empty value removes a parameter.
Attempt solve(const Scenario &scenario, const Parameters &changes = {}, const std::string &space = "absolute")
{
    Parameters parameters = scenario.methods.count("hppm") > 0 ? scenario.methods.at("hppm") : Parameters();
    for (const auto &[name, value] : changes)
        parameters[name] = value;
    Attempt attempt{scenario, makeProblem(scenario, {"analytic", "continuous", space}), nullptr, {}};
    attempt.planner = makePlanner("hppm", attempt.problem.context, parameters);
    attempt.planner->setProblemDefinition(attempt.problem.pdef);
    attempt.planner->setup();
    attempt.status = attempt.planner->solve(ob::plannerNonTerminatingCondition());
    return attempt;
}

class HPPMCases : public testing::TestWithParam<std::tuple<int, const char *, const char *>>
{
};

TEST_P(HPPMCases, SolvesThePapersCaseByTheScenariosRecipe)
{
    const auto [number, form, space] = GetParam();
    const Attempt attempt = solve(paperCase(number), {{"form", form}}, space);
    EXPECT_EQ(attempt.status, ob::PlannerStatus::EXACT_SOLUTION) << attempt.hppm().reason();
    EXPECT_EQ(attempt.hppm().reason(), "");
    auto &path = *attempt.problem.pdef->getSolutionPath()->as<og::PathGeometric>();
    EXPECT_TRUE(attempt.problem.si->equalStates(path.getState(0), attempt.problem.pdef->getStartState(0)));
    EXPECT_TRUE(attempt.problem.pdef->getGoal()->isSatisfied(path.getStates().back()));
    EXPECT_GT(attempt.hppm().measures().at("homotopy_evaluations"), 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, HPPMCases,
                         testing::Combine(testing::Values(1, 2, 3), testing::Values("plane", "full"),
                                          testing::Values("absolute", "absolute_line")));

TEST(HPPM, CountsThePapersHyperspheres)
{
    EXPECT_EQ(solve(paperCase(1), {{"form", "full"}}).hppm().measures().at("hyperspheres"), 146.0);
    EXPECT_EQ(solve(paperCase(2), {{"form", "full"}}).hppm().measures().at("hyperspheres"), 323.0);
    EXPECT_EQ(solve(paperCase(3), {{"form", "full"}}).hppm().measures().at("hyperspheres"), 966.0);
}

TEST(HPPM, NamesWhyItStopped)
{
    const auto reason = [](const Scenario &scenario, const Parameters &changes)
    {
        const Attempt attempt = solve(scenario, changes);
        EXPECT_EQ(attempt.status, ob::PlannerStatus::ABORT);
        EXPECT_FALSE(attempt.problem.pdef->hasSolution());
        return attempt.hppm().reason();
    };
    for (const char *form : {"plane", "full"})
    {
        EXPECT_EQ(reason(paperCase(1), {{"form", form}, {"points_per_link", "20"}}), "turned_back");
        EXPECT_EQ(reason(paperCase(2), {{"form", form}, {"lambda_max", "1"}}), "wrong_root");
        EXPECT_EQ(reason(paperCase(3), {{"form", form}, {"repulsion", "1e-7, -1.2, 450, 60, -0.0001, 10, -63"}}),
                  "wrong_root");
    }
    // Spheres so large that their chords cut a corner: the curve arrives, the validator says no.
    EXPECT_EQ(reason(paperCase(2), {{"form", "full"}, {"radius", "0.08"}}), "collision");
    // Poles of one sign, however thin, do not let the curve between them.
    EXPECT_EQ(reason(paperCase(1), {{"repulsion", "1e-6"}}), "wrong_root");
}

TEST(HPPM, SaysThatThePaperHasNoPolygons)
{
    Scenario scenario = paperCase(1);
    PlanarModel model = *scenario.planar().model;
    model.obstacles.push_back({"P", Polygon{{{9, 9}, {10, 9}, {9, 10}}}});
    scenario.planar().model = std::make_shared<PlanarModel>(model);
    scenario.methods.clear();
    const Attempt attempt = solve(scenario, {{"search", "paper"}});
    EXPECT_EQ(attempt.status, ob::PlannerStatus::ABORT);
    EXPECT_EQ(attempt.hppm().reason(), "no_points");
}

TEST(HPPM, ASecondCallKeepsTheSolutionAndClearStartsAfresh)
{
    Attempt attempt = solve(paperCase(1));
    EXPECT_EQ(attempt.planner->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
    attempt.planner->clear();
    attempt.problem.pdef->clearSolutionPaths();
    EXPECT_TRUE(attempt.hppm().measures().empty());
    EXPECT_EQ(attempt.planner->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(attempt.problem.pdef->getSolutionCount(), 1u);
}

TEST(HPPM, ExpiredConditionIsATimeout)
{
    const Scenario scenario = paperCase(1);
    const Problem problem = makeProblem(scenario);
    const ob::PlannerPtr planner = makePlanner("hppm", problem.context, scenario.methods.at("hppm"));
    planner->setProblemDefinition(problem.pdef);
    EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
}

TEST(HPPM, RefusesParametersThatDoNotFit)
{
    const Problem problem = makeProblem(paperCase(1));
    HPPM planner(problem.si, problem.context.repulsion());
    EXPECT_THROW(planner.setForm("spiral"), std::invalid_argument);
    EXPECT_THROW(planner.setPointsPerLink(0), std::invalid_argument);
    EXPECT_THROW(planner.setRepulsion("0.1, 0.2, 0.3"), std::invalid_argument);
    EXPECT_THROW(planner.setRepulsion("much"), std::invalid_argument);
    EXPECT_THROW(planner.setRepulsion(""), std::invalid_argument);
    EXPECT_THROW(planner.setRows("1, 2; 3, 4"), std::invalid_argument);
    EXPECT_THROW(planner.setDirection("0, 0, 0"), std::invalid_argument);
    EXPECT_THROW(planner.setStrength("0"), std::invalid_argument);
    EXPECT_THROW(planner.setRadius(-0.02), std::invalid_argument);
    EXPECT_THROW(planner.setOrientation("up"), std::invalid_argument);
    EXPECT_THROW(planner.setLambdaMin(0.0), std::invalid_argument);
    EXPECT_THROW(planner.setLambdaMax(0.9), std::invalid_argument);
    EXPECT_THROW(planner.setMaxStep(-0.1), std::invalid_argument);
    EXPECT_THROW(planner.setSearch("depth_first"), std::invalid_argument);
    EXPECT_THROW(planner.setTries(0), std::invalid_argument);
    EXPECT_THROW(planner.setPoleRows(3), std::invalid_argument);
    EXPECT_THROW(planner.setPoles("springs"), std::invalid_argument);
    EXPECT_THROW(planner.setTurns("1, 0"), std::invalid_argument);
    EXPECT_THROW(planner.setTurns("0.5, 0, 0"), std::invalid_argument);
    EXPECT_THROW(planner.setHeld("2, 0, 0"), std::invalid_argument);
    EXPECT_THROW(planner.setHeldShare(1.0), std::invalid_argument);
    EXPECT_THROW(planner.setTracedFrom("middle"), std::invalid_argument);
    EXPECT_THROW(planner.setMaxDeviation(0.0), std::invalid_argument);
}

TEST(HPPM, ParametersReadBackAsTheyWereSet)
{
    const Scenario scenario = paperCase(2);
    const Problem problem = makeProblem(scenario);
    HPPM planner(problem.si, problem.context.repulsion());
    planner.setRows(scenario.methods.at("hppm").at("rows"));
    EXPECT_EQ(parseMatrix(planner.getRows()), parseMatrix(scenario.methods.at("hppm").at("rows")));
    planner.setDirection("1, 0, 0, 0, 0, 0, 0, 0.1");
    EXPECT_EQ(planner.getDirection(), "1, 0, 0, 0, 0, 0, 0, 0.1");
}

TEST(HPPM, PlannerDataHoldsTheTrace)
{
    const Attempt attempt = solve(paperCase(1));
    ob::PlannerData data(attempt.problem.si);
    attempt.planner->getPlannerData(data);
    EXPECT_EQ(data.numStartVertices(), 1u);
    EXPECT_EQ(data.numGoalVertices(), 1u);
    EXPECT_EQ(data.numEdges() + 1, data.numVertices());
}
}  // namespace
}  // namespace narrows
