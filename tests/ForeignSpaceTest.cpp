// SPDX-License-Identifier: BSD-3-Clause
// What planners of ours answer in spaces that are not theirs: they can be made there, as OMPL's can, and say so by
// status.
#include <functional>
#include <map>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "TinyChainProblem.h"
#include "TinyPipeProblem.h"
#include "kernel/ControlPoints.h"
#include "planners/HPPM.h"
#include "planners/Threader.h"
#include "planners/TightManeuvering.h"
#include "planners/VDSM.h"
#include "planners/ViaPointHomotopy.h"
#include "spaces/PlanarArmStateSpace.h"

namespace narrows
{
namespace
{
using Make = std::function<std::shared_ptr<ModelPlanner>(const ob::SpaceInformationPtr &)>;

std::shared_ptr<const PlanarModel> chain()
{
    return tinyChainScenario().planar().model;
}

std::shared_ptr<const SpatialModel> spatialChain()
{
    return std::make_shared<SpatialModel>(SpatialModel{hyperRedundantArm(), {}});
}

const std::map<std::string, Make> &makers()
{
    static const std::map<std::string, Make> all{
        {"hppm",
         [](const auto &si)
         {
             return std::make_shared<HPPM>(si, controlPointModel(pointRobot(2), {}, 1.0));
         }},
        {"threader",
         [](const auto &si)
         {
             return std::make_shared<Threader>(si, nullptr, nullptr, nullptr);
         }},
        {"tight",
         [](const auto &si)
         {
             return std::make_shared<TightManeuvering>(si, nullptr, nullptr);
         }},
        {"tight_chain",
         [](const auto &si)
         {
             return std::make_shared<TightManeuvering>(si, chain(), nullptr);
         }},
        {"tight_spatial",
         [](const auto &si)
         {
             return std::make_shared<TightManeuvering>(si, nullptr, spatialChain());
         }},
        {"vdsm",
         [](const auto &si)
         {
             return std::make_shared<VDSM>(si, nullptr);
         }},
        {"vdsm_spatial",
         [](const auto &si)
         {
             return std::make_shared<VDSM>(si, spatialChain());
         }},
        {"viapoint", [](const auto &si)
         {
             return std::make_shared<ViaPointHomotopy>(si, false);
         }}};
    return all;
}

/// A problem that a straight motion solves.
struct Question
{
    explicit Question(const ob::StateSpacePtr &space)
      : si(std::make_shared<ob::SpaceInformation>(space)), pdef(std::make_shared<ob::ProblemDefinition>(si))
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        si->setStateValidityChecker(
            [this](const ob::State *)
            {
                ++asked;
                return true;
            });
        si->setup();
        ob::ScopedState<> start(space), goal(space);
        for (unsigned int i = 0; i < 2; ++i)
            start[i] = 0.1, goal[i] = 0.4;
        pdef->setStartAndGoalStates(start, goal);
    }

    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr pdef;
    int asked = 0;  ///< states whose validity was asked for
};

ob::StateSpacePtr plane()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 1.0);
    return space;
}

/// A body in the plane: its states are no vectors.
ob::StateSpacePtr body()
{
    auto space = std::make_shared<ob::SE2StateSpace>();
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0.0), bounds.setHigh(1.0);
    space->setBounds(bounds);
    return space;
}

void expectRefused(ModelPlanner &planner, const Question &question)
{
    const int before = question.asked;
    EXPECT_EQ(planner.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::ABORT);
    EXPECT_EQ(planner.reason(), "space");
    EXPECT_FALSE(question.pdef->hasSolution());
    EXPECT_EQ(question.asked, before);
}

class ForeignSpace : public testing::TestWithParam<std::string>
{
protected:
    static std::shared_ptr<ModelPlanner> make(const Question &question) { return makers().at(GetParam())(question.si); }
};

TEST_P(ForeignSpace, IsRefusedByStatus)
{
    const Question question(body());
    const auto planner = make(question);
    EXPECT_THROW(planner->solve(ob::plannerNonTerminatingCondition()), ompl::Exception);  // no problem yet
    planner->setProblemDefinition(question.pdef);
    expectRefused(*planner, question);
    expectRefused(*planner, question);
    planner->clear();
    EXPECT_EQ(planner->reason(), "");
    ob::PlannerData data(question.si);
    planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), 0u);
    expectRefused(*planner, question);
}

TEST_P(ForeignSpace, TakesAndKeepsParameters)
{
    const Question question(body());
    const auto planner = make(question);
    std::map<std::string, std::string> before, after;
    planner->params().getParams(before);
    EXPECT_FALSE(before.empty());
    // Numbers that stand for "choose" and ranges that depend on a robot must hold without one too.
    for (const auto &[name, value] : before)
        EXPECT_TRUE(value.empty() || planner->params().setParam(name, value)) << name;
    planner->params().getParams(after);
    EXPECT_EQ(before, after);
}

INSTANTIATE_TEST_SUITE_P(Ours, ForeignSpace, testing::Values("hppm", "threader", "tight", "vdsm", "viapoint"),
                         [](const auto &planner) { return planner.param; });

/// Spaces of vectors, which hppm and viapoint plan in.
class VectorSpace : public ForeignSpace
{
};

TEST_P(VectorSpace, IsRefusedByStatusWithoutAnArm)
{
    const Question question(plane());
    const auto planner = make(question);
    planner->setProblemDefinition(question.pdef);
    expectRefused(*planner, question);
}

INSTANTIATE_TEST_SUITE_P(Ours, VectorSpace,
                         testing::Values("threader", "tight", "tight_chain", "tight_spatial", "vdsm", "vdsm_spatial"),
                         [](const auto &planner) { return planner.param; });
TEST(AnotherArmsSpace, IsRefusedByStatus)
{
    const PlanarArm fixed({0.0, 0.0}, {{1.0, -1}, {1.0, 0}});
    JointLimits none;
    none.angles.resize(2);
    const Question question(
        std::make_shared<PlanarArmStateSpace>(fixed, AngleConvention::Absolute, FreeJoints::Wrapping, none));
    for (const std::string name : {"tight_chain", "tight_spatial", "vdsm_spatial"})
    {
        SCOPED_TRACE(name);
        const auto planner = makers().at(name)(question.si);
        planner->setProblemDefinition(question.pdef);
        expectRefused(*planner, question);
    }
}
}  // namespace
}  // namespace narrows
