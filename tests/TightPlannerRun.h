// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include "PlannerTrial.h"
#include "planners/TightManeuvering.h"

namespace narrows
{
/// Scenarios of `tight`, by the end of their file's name.
inline Scenario tightScenario(const std::string &file, const GenerateSettings &settings = {})
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/tight_" + file + ".yaml", settings);
}

inline Scenario ladderScenario(const std::string &shape, const std::string &length)
{
    return tightScenario("ladder", {{"shape", shape}, {"length", length}});
}

/// The planner on a fresh problem.
struct TightPlannerRun
{
    explicit TightPlannerRun(Scenario of, const std::map<std::string, std::string> &parameters = {})
      : scenario(std::move(of)), problem(quietProblem(scenario))
    {
        planner = std::dynamic_pointer_cast<TightManeuvering>(makePlanner("tight", problem.context, parameters));
        planner->setProblemDefinition(problem.pdef);
        planner->setup();
    }

    ob::PlannerStatus::StatusType solve(long patience = 10'000'000)
    {
        const ob::PlannerStatus status = planner->solve(questions(patience));
        expectTruthful(status, *problem.pdef);
        return status;
    }

    double measure(const std::string &name) const { return planner->measures().at(name); }
    std::vector<Eigen::VectorXd> path() const
    {
        return problem.space->unwrap(*problem.pdef->getSolutionPath()->as<og::PathGeometric>());
    }

    Scenario scenario;
    Problem problem;
    std::shared_ptr<TightManeuvering> planner;

private:
    static Problem quietProblem(const Scenario &scenario)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        return makeProblem(scenario);
    }
};

inline void expectVerified(const TightPlannerRun &run)
{
    ASSERT_TRUE(run.problem.pdef->hasExactSolution()) << run.scenario.name << " " << run.planner->reason();
    EXPECT_EQ(run.planner->reason(), "");
    const Verdict verdict = verify(run.scenario.world, run.path());
    EXPECT_TRUE(verdict.accepted) << verdict.reason << " " << verdict.segment << " " << verdict.obstacle;
}

inline void expectVerified(TightPlannerRun &&run)
{
    run.solve();
    expectVerified(run);
}

/// Everything has been tried in vain.
inline void expectRefused(TightPlannerRun &&run, const std::string &reason)
{
    EXPECT_EQ(run.solve(), ob::PlannerStatus::ABORT) << run.scenario.name;
    EXPECT_EQ(run.planner->reason(), reason) << run.scenario.name;
    EXPECT_FALSE(run.problem.pdef->hasSolution());
}
}  // namespace narrows
