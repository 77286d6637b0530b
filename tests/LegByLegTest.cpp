// SPDX-License-Identifier: BSD-3-Clause
#include "planners/LegByLeg.h"

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>

#include "TipPathScenes.h"

namespace narrows
{
namespace
{
/// What the planners below did, in order.
struct Diary
{
    std::vector<double> ranges;  ///< of each that solved
    int made = 0;
    int failAt = -1;  ///< the leg, from 0, whose planner gives up
};

/// Goes straight to a sample of its goal, whatever is in the way.
class StraightLeg : public ModelPlanner
{
public:
    StraightLeg(const ob::SpaceInformationPtr &si, Diary &diary) : ModelPlanner(si, "StraightLeg"), diary_(diary)
    {
        ++diary_.made;
        declareParam<double>("range", this, &StraightLeg::setRange, &StraightLeg::getRange);
    }

    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
    {
        checkValidity();
        if (ptc)
            return ob::PlannerStatus::TIMEOUT;
        measures_["solves"] += 1.0;
        if (static_cast<int>(diary_.ranges.size()) == diary_.failAt)
        {
            reason_ = "no_way";
            return ob::PlannerStatus::ABORT;
        }
        diary_.ranges.push_back(range_);
        path_ = std::make_shared<og::PathGeometric>(si_, pis_.nextStart(), pis_.nextGoal(ptc));
        pdef_->addSolutionPath(std::make_shared<og::PathGeometric>(*path_), false, 0.0, getName());
        return ob::PlannerStatus::EXACT_SOLUTION;
    }
    using ob::Planner::solve;

    void getPlannerData(ob::PlannerData &data) const override
    {
        Planner::getPlannerData(data);
        if (path_)
            data.addEdge(ob::PlannerDataVertex(path_->getState(0)), ob::PlannerDataVertex(path_->getState(1)));
    }

    void setRange(double range) { range_ = range; }
    double getRange() const { return range_; }

private:
    Diary &diary_;
    double range_ = 1.0;
    std::shared_ptr<og::PathGeometric> path_;
};

class LegByLegTest : public testing::Test
{
protected:
    Trial straight()
    {
        Trial trial{seeded(scenario_), nullptr};
        const auto make = [this, si = trial.problem.si]
        {
            return std::make_shared<StraightLeg>(si, diary_);
        };
        trial.planner = std::make_shared<LegByLeg>(trial.problem.si, make);
        trial.planner->setProblemDefinition(trial.problem.pdef);
        trial.planner->setup();
        return trial;
    }

    static const ModelPlanner &model(const Trial &trial) { return static_cast<const ModelPlanner &>(*trial.planner); }

    const std::vector<Eigen::Vector3d> &points() const
    {
        return std::get<SpatialTipPath>(scenario_.spatial().task.goal).points;
    }

    Eigen::Vector3d tipAt(const Trial &trial, unsigned int state) const
    {
        return static_cast<const SpatialArmStateSpace &>(*trial.problem.space).tip(trial.path().getState(state), 2);
    }

    Scenario scenario_ = tinyTipPathScenario();
    Diary diary_;
};

TEST_F(LegByLegTest, LeadsRrtConnectAlongThreePoints)
{
    const Trial trial = spatialTrial("rrtconnect", scenario_, {{"range", "0.4"}});
    ASSERT_NE(dynamic_cast<const LegByLeg *>(trial.planner.get()), nullptr);
    ASSERT_EQ(type(trial.planner->solve(questions(20'000))), ob::PlannerStatus::EXACT_SOLUTION);
    const Verdict verdict = verdictOf(scenario_, trial);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(model(trial).measures().at("points_reached"), 3.0);
    EXPECT_EQ(model(trial).reason(), "");
    EXPECT_EQ(trial.planner->getName(), "RRTConnect");
    const og::PathGeometric &path = trial.path();
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        EXPECT_LE(trial.problem.si->distance(path.getState(i - 1), path.getState(i)), 0.4 + 1e-9);
}

TEST_F(LegByLegTest, RepeatsItselfForTheSameSeed)
{
    const auto solve = [this]
    {
        Trial trial = spatialTrial("rrtconnect", scenario_);
        trial.planner->solve(questions(20'000));
        return trial;
    };
    const Trial first = solve();
    const Trial second = solve();
    EXPECT_EQ(first.problem.counts->motionChecks, second.problem.counts->motionChecks);
    ASSERT_EQ(first.path().getStateCount(), second.path().getStateCount());
    for (unsigned int i = 0; i < first.path().getStateCount(); ++i)
        EXPECT_TRUE(first.problem.si->equalStates(first.path().getState(i), second.path().getState(i))) << i;
}

TEST_F(LegByLegTest, LeavesPlannersAloneThatHaveNoTipPathToFollow)
{
    const Trial trial = spatialTrial("rrtconnect", tinySpatialScenario());
    EXPECT_EQ(dynamic_cast<const LegByLeg *>(trial.planner.get()), nullptr);
}

TEST_F(LegByLegTest, MakesAPlannerForEachLegWithItsParameters)
{
    const Trial trial = straight();
    EXPECT_TRUE(trial.planner->params().setParam("range", "0.25"));
    ASSERT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(diary_.ranges, std::vector<double>(3, 0.25));
    EXPECT_EQ(diary_.made, 4);  // one that only holds the parameters
    ASSERT_EQ(trial.path().getStateCount(), 4U);
    for (unsigned int i = 0; i < 3; ++i)
        EXPECT_LT((tipAt(trial, i + 1) - points()[i]).norm(), 1e-3) << i;
    EXPECT_EQ(model(trial).measures().at("solves"), 3.0);
}

TEST_F(LegByLegTest, NeedsNoLegToAPointWhereTheTipIsAlready)
{
    SpatialTask &task = scenario_.spatial().task;
    auto &path = std::get<SpatialTipPath>(task.goal);
    path.points.insert(path.points.begin(), tipOf(scenario_.spatial().model->arm, task.start));
    path.points.push_back(path.points.back());
    const Trial trial = straight();
    ASSERT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(diary_.ranges.size(), 3U);
    EXPECT_EQ(model(trial).measures().at("points_reached"), 5.0);
}

TEST_F(LegByLegTest, ReportsWhatItReachedWhenALegFails)
{
    diary_.failAt = 2;
    const Trial trial = straight();
    ASSERT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(model(trial).reason(), "no_way");
    EXPECT_EQ(model(trial).measures().at("points_reached"), 2.0);
    EXPECT_EQ(trial.path().getStateCount(), 3U);
    EXPECT_NEAR(trial.problem.pdef->getSolutionDifference(), (points()[2] - points()[1]).norm(), 2e-3);
    // A later call goes on from there.
    diary_.failAt = -1;
    ASSERT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(trial.path().getStateCount(), 4U);
    EXPECT_EQ(diary_.ranges.size(), 3U);
    EXPECT_EQ(model(trial).reason(), "");
}

TEST_F(LegByLegTest, HasNothingToReportWhenTheFirstLegFails)
{
    diary_.failAt = 0;
    const Trial trial = straight();
    EXPECT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::ABORT);
    EXPECT_EQ(model(trial).reason(), "no_way");
    EXPECT_FALSE(trial.problem.pdef->hasSolution());
}

TEST_F(LegByLegTest, SharesItsTimeAmongTheLegs)
{
    // Each leg of the straight planner costs a few questions: somewhere in between some points have been reached.
    std::set<double> reached;
    for (long limit = 0; limit < 20; ++limit)
    {
        const Trial trial = straight();
        const ob::PlannerStatus status = trial.planner->solve(questions(limit));
        expectTruthful(status, *trial.problem.pdef);
        const double points = model(trial).measures().at("points_reached");
        reached.insert(points);
        EXPECT_EQ(type(status), points == 0.0   ? ob::PlannerStatus::TIMEOUT
                                : points == 3.0 ? ob::PlannerStatus::EXACT_SOLUTION
                                                : ob::PlannerStatus::APPROXIMATE_SOLUTION)
            << status.asString();
        EXPECT_EQ(model(trial).reason(), "");
    }
    EXPECT_EQ(reached, (std::set<double>{0.0, 1.0, 2.0, 3.0}));
}

TEST_F(LegByLegTest, ForgetsItsWorkAndKeepsItsParameters)
{
    const Trial trial = straight();
    trial.planner->params().setParam("range", "0.5");
    trial.planner->solve(questions(100));
    trial.planner->clear();
    trial.problem.pdef->clearSolutionPaths();
    EXPECT_TRUE(model(trial).measures().empty());
    ob::PlannerData none(trial.problem.si);
    trial.planner->getPlannerData(none);
    EXPECT_EQ(none.numVertices(), 0U);
    ASSERT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(diary_.ranges, std::vector<double>(6, 0.5));
}

TEST_F(LegByLegTest, ShowsTheGraphsOfAllLegs)
{
    const Trial trial = straight();
    trial.planner->solve(questions(100));
    ob::PlannerData data(trial.problem.si);
    trial.planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), 6U);
    EXPECT_EQ(data.numEdges(), 3U);
}

TEST_F(LegByLegTest, KeepsASolution)
{
    const Trial trial = straight();
    trial.planner->solve(questions(100));
    EXPECT_EQ(type(trial.planner->solve(questions(100))), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(trial.problem.pdef->getSolutionCount(), 1U);
    EXPECT_EQ(diary_.ranges.size(), 3U);
}

TEST_F(LegByLegTest, RefusesOtherGoalsAndBadStarts)
{
    {
        const Trial trial = straight();
        trial.problem.pdef->setGoal(seeded(tinySpatialScenario()).pdef->getGoal());
        EXPECT_EQ(type(trial.planner->solve(questions(10))), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
    }
    const Trial trial = straight();
    trial.problem.si->setStateValidityChecker([](const ob::State *) { return false; });
    EXPECT_EQ(type(trial.planner->solve(questions(10))), ob::PlannerStatus::INVALID_START);
}

TEST_F(LegByLegTest, RefusesParametersThatThePlannerDoesNotHave)
{
    const Problem problem = seeded(scenario_);
    EXPECT_THROW(makePlanner("rrtconnect", problem.context, {{"rnge", "1"}}), ParameterError);
}

TEST_F(LegByLegTest, LeadsPlannersOfEveryKind)
{
    for (const char *name : {"rrt", "bkpiece1", "est", "rrtstar", "bitstar", "prm", "fmt", "hppm"})
    {
        const Trial trial = spatialTrial(name, scenario_);
        const ob::PlannerStatus status = trial.planner->solve(questions(enoughFor(name)));
        expectTruthful(status, *trial.problem.pdef);
        if (status == ob::PlannerStatus::EXACT_SOLUTION)
        {
            EXPECT_EQ(verdictOf(scenario_, trial).reason, "") << name;
        }
        else
            EXPECT_NE(type(status), ob::PlannerStatus::ABORT) << name;
    }
}
}  // namespace
}  // namespace narrows
