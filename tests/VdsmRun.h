// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include "PlannerTrial.h"
#include "TinyPipeProblem.h"
#include "planners/ModelPlanner.h"
#include "validity/Verifier.h"

namespace narrows
{
/// One run of the planner, and what the verifier says of its path.
class VdsmRun
{
public:
    explicit VdsmRun(const Scenario &scenario, const std::map<std::string, std::string> &parameters = {},
                     long patience = 1'000'000)
      : world_(std::get<SpatialWorld>(scenario.world)), problem_(quietProblem(scenario))
    {
        planner = makePlanner("vdsm", problem_.context, parameters);
        planner->setProblemDefinition(problem_.pdef);
        planner->setup();
        status = planner->solve(questions(patience));
    }

    const ModelPlanner &model() const { return dynamic_cast<const ModelPlanner &>(*planner); }
    std::string reason() const { return model().reason(); }
    double measure(const std::string &name) const { return model().measures().at(name); }
    std::vector<Eigen::VectorXd> path() const
    {
        return problem_.space->unwrap(*problem_.pdef->getSolutionPath()->as<og::PathGeometric>());
    }
    Verdict verdict() const { return verify(*world_.model, world_.task, path()); }
    bool solved() const { return status == ob::PlannerStatus::EXACT_SOLUTION; }
    const ob::ProblemDefinition &pdef() const { return *problem_.pdef; }

    ob::PlannerPtr planner;
    ob::PlannerStatus status;

private:
    static Problem quietProblem(const Scenario &scenario)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        return makeProblem(scenario);
    }

    SpatialWorld world_;
    Problem problem_;
};

inline SpatialTipGoal tipAt(double y, double z, double x = 3126.0)
{
    return {7, {x, y, z}, 1e-6};
}

inline void expectVerified(const VdsmRun &run)
{
    ASSERT_TRUE(run.solved()) << run.status.asString() << " " << run.reason();
    EXPECT_EQ(run.reason(), "");
    const Verdict verdict = run.verdict();
    EXPECT_TRUE(verdict.accepted) << verdict.reason << " " << verdict.segment << " " << verdict.obstacle;
}
}  // namespace narrows
