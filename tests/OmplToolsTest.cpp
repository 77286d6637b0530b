// SPDX-License-Identifier: BSD-3-Clause
// Our planners in the hands of OMPL's own tools: SimpleSetup, Benchmark, ParallelPlan, PathSimplifier and the storage
// of planner data.
#include <functional>
#include <sstream>

#include <gtest/gtest.h>
#include <ompl/base/PlannerDataStorage.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/tools/multiplan/ParallelPlan.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "PaperCases.h"
#include "kernel/ControlPoints.h"
#include "kernel/PlanarRepulsionModel.h"
#include "planners/HPPM.h"
#include "planners/Threader.h"
#include "planners/ViaPointHomotopy.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
class OmplTools : public testing::TestWithParam<std::string>
{
protected:
    OmplTools()
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // setSeed() says that it comes late
        ompl::RNG::setSeed(3);
        problem_ = makeProblem(paperCase(1));
    }

    ob::PlannerPtr planner() const { return makePlanner(GetParam(), problem_.context); }

    /// A SimpleSetup of the problem with the planner.
    og::SimpleSetup setup() const
    {
        og::SimpleSetup setup(problem_.si);
        const ob::ScopedState<> start(problem_.space, problem_.pdef->getStartState(0));
        setup.setStartState(start);
        setup.setGoal(problem_.pdef->getGoal());
        setup.setPlanner(planner());
        return setup;
    }

    Problem problem_;
};

TEST_P(OmplTools, SimpleSetupSolvesAndSimplifies)
{
    og::SimpleSetup setup = this->setup();
    ASSERT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double before = setup.getSolutionPath().length();
    setup.simplifySolution();
    EXPECT_TRUE(setup.getSolutionPath().check());
    EXPECT_LE(setup.getSolutionPath().length(), before * (1.0 + 1e-9));
    setup.clear();
    EXPECT_FALSE(setup.haveSolutionPath());
    EXPECT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_P(OmplTools, PathSimplifierKeepsThePathFree)
{
    const ob::PlannerPtr planner = this->planner();
    planner->setProblemDefinition(problem_.pdef);
    ASSERT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    og::PathGeometric path(*problem_.pdef->getSolutionPath()->as<og::PathGeometric>());
    og::PathSimplifier(problem_.si, problem_.pdef->getGoal()).simplifyMax(path);
    EXPECT_TRUE(path.check());
    EXPECT_TRUE(problem_.space->equalStates(path.getState(0), problem_.pdef->getStartState(0)));
    EXPECT_TRUE(problem_.pdef->getGoal()->isSatisfied(path.getStates().back()));
}

TEST_P(OmplTools, BenchmarkRunsIt)
{
    og::SimpleSetup setup = this->setup();
    ompl::tools::Benchmark benchmark(setup, "tools");
    benchmark.addPlanner(planner());
    ompl::tools::Benchmark::Request request;
    request.maxTime = 10.0;
    request.runCount = 3;
    request.displayProgress = false;
    request.saveConsoleOutput = false;
    benchmark.benchmark(request);
    const auto &runs = benchmark.getRecordedExperimentData().planners.at(0).runs;
    ASSERT_EQ(runs.size(), 3u);
    for (const auto &run : runs)
    {
        EXPECT_EQ(run.at("solved BOOLEAN"), "1");
        EXPECT_EQ(run.at("correct solution BOOLEAN"), "1");
    }
}

TEST_P(OmplTools, ParallelPlanTakesTwoOfThem)
{
    ompl::tools::ParallelPlan together(problem_.pdef);
    together.addPlanner(planner());
    together.addPlanner(planner());
    EXPECT_EQ(together.solve(10.0, 1, 2, false), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(problem_.pdef->getSolutionPath()->check());
}

TEST_P(OmplTools, PlannerDataCanBeStored)
{
    const ob::PlannerPtr planner = this->planner();
    planner->setProblemDefinition(problem_.pdef);
    ASSERT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(problem_.si), loaded(problem_.si);
    planner->getPlannerData(data);
    EXPECT_GT(data.numEdges(), 0u);
    EXPECT_GE(data.numStartVertices(), 1u);
    EXPECT_GE(data.numGoalVertices(), 1u);
    std::stringstream stored;
    ob::PlannerDataStorage storage;
    storage.store(data, stored);
    storage.load(stored, loaded);
    EXPECT_EQ(loaded.numVertices(), data.numVertices());
    EXPECT_EQ(loaded.numEdges(), data.numEdges());
    EXPECT_EQ(loaded.numStartVertices(), data.numStartVertices());
    EXPECT_EQ(loaded.numGoalVertices(), data.numGoalVertices());
}

/// A planner's status and reason in a space that is not for it.
void expectRefusal(const ob::StateSpacePtr &space,
                   const std::function<std::shared_ptr<ModelPlanner>(const ob::SpaceInformationPtr &)> &make)
{
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<> start(space), goal(space);
    start = std::vector<double>{0.0, 0.0, 0.0};
    goal = std::vector<double>{1.0, 1.0, 1.0};
    pdef->setStartAndGoalStates(start, goal);
    const std::shared_ptr<ModelPlanner> planner = make(si);
    planner->setProblemDefinition(pdef);
    EXPECT_EQ(planner->solve(1.0), ob::PlannerStatus::ABORT) << planner->getName();
    EXPECT_EQ(planner->reason(), "space") << planner->getName();
    EXPECT_FALSE(pdef->hasSolution());
}

TEST(PlannersInAStrangeSpace, SaySoByStatus)
{
    const auto turning = std::make_shared<ob::SE2StateSpace>();
    ob::RealVectorBounds bounds(2);
    bounds.setLow(-3.0);
    bounds.setHigh(3.0);
    turning->setBounds(bounds);
    const auto plain = std::make_shared<ob::RealVectorStateSpace>(3);
    plain->setBounds(-3.0, 3.0);
    const auto arm = planarRepulsionModel(paperCase(1).planar().model, {});
    const auto point = controlPointModel(pointRobot(2), {}, 1.0);
    expectRefusal(turning, [&](const auto &si) { return std::make_shared<HPPM>(si, arm); });
    expectRefusal(plain, [&](const auto &si) { return std::make_shared<HPPM>(si, point); });
    expectRefusal(turning, [](const auto &si) { return std::make_shared<ViaPointHomotopy>(si, false); });
    expectRefusal(plain, [](const auto &si) { return std::make_shared<Threader>(si, nullptr, nullptr, nullptr); });
}

INSTANTIATE_TEST_SUITE_P(Ours, OmplTools, testing::Values("hppm", "threader", "viapoint"));
}  // namespace
}  // namespace narrows
