// SPDX-License-Identifier: BSD-3-Clause
// Scenes with a proof that there is no way: the proofs, checked in the whole of the joint space.
#include <cstdlib>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "JointCells.h"
#include "scenario/Problem.h"
#include "scenario/Scenario.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
using testing::HasSubstr;
using Texts = std::map<std::string, std::string>;

struct Sealed
{
    std::string family;
    Texts parameters;
    Texts open;               ///< what makes it a scene with a way instead
    std::vector<int> counts;  ///< of cells
};

void PrintTo(const Sealed &sealed, std::ostream *out)
{
    *out << sealed.family;
    for (const auto &[key, value] : sealed.parameters)
        *out << " " << key << " " << value;
}

ArmScene draw(const Sealed &sealed, int seed, bool open = false)
{
    Texts given = sealed.parameters;
    for (const auto &[key, value] : open ? sealed.open : Texts{})
        given[key] = value;
    given["seed"] = std::to_string(seed);
    const Family &family = findFamily(sealed.family);
    return std::get<ArmScene>(family.draw(family.values(given)));
}

Scenario read(const ArmScene &scene)
{
    return parseScenario(toYaml(scene, "scene", "test"), "scene");
}

/// Scenes per case: NARROWS_FAMILY_INSTANCES=1000 makes this test a long one.
int instances(int otherwise)
{
    const char *asked = std::getenv("NARROWS_FAMILY_INSTANCES");
    return asked != nullptr ? std::atoi(asked) : otherwise;
}

constexpr int looks = 10;  // at each link: blocked cells are deep enough in obstacles

class SealedScenes : public testing::TestWithParam<Sealed>
{
};

TEST_P(SealedScenes, HaveNoWayInTheWholeJointSpace)
{
    for (int seed = 1; seed <= instances(3); ++seed)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const ArmScene scene = draw(GetParam(), seed);
        EXPECT_TRUE(scene.witness.empty());
        const Scenario scenario = read(scene);  // which checks the proof
        ASSERT_TRUE(scenario.infeasible.has_value());
        const PlanarModel model = modelOf(scene);
        const JointCells cells(model, GetParam().counts, looks);
        EXPECT_NE(cells.at(scene.start), JointCells::Cell::Blocked);
        EXPECT_NE(cells.at(scene.goal), JointCells::Cell::Blocked);
        EXPECT_FALSE(cells.mayJoin(scene.start, scene.goal));
        EXPECT_EQ(toYaml(scene, "s", "t"), toYaml(draw(GetParam(), seed), "s", "t")) << "same seed, same file";
    }
}

// The same cells do not separate the ends of scenes that have a way: they do not simply always separate.
TEST_P(SealedScenes, HaveAWayWhereTheyAreOpen)
{
    for (int seed = 1; seed <= instances(3); ++seed)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const ArmScene scene = draw(GetParam(), seed, true);
        EXPECT_FALSE(scene.infeasible.has_value());
        EXPECT_FALSE(read(scene).infeasible.has_value());
        const PlanarModel model = modelOf(scene);
        const JointCells cells(model, GetParam().counts, looks);
        EXPECT_TRUE(cells.mayJoin(scene.start, scene.goal));
        for (const Eigen::VectorXd &q : scene.witness)
            EXPECT_NE(cells.at(q), JointCells::Cell::Blocked);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Families, SealedScenes,
    testing::Values(Sealed{"blind", {{"links", "1"}, {"half_width", "-0.05"}}, {{"half_width", "0.05"}}, {600, 60}},
                    Sealed{"blind", {{"links", "2"}, {"half_width", "-0.05"}}, {{"half_width", "0.05"}}, {400, 16, 16}},
                    Sealed{"blind",
                           {{"links", "2"}, {"half_width", "-0.05"}, {"shape", "box"}},
                           {{"half_width", "0.05"}},
                           {400, 16, 16}},
                    Sealed{"blind",
                           {{"links", "1"}, {"half_width", "-0.08"}, {"shape", "polygon"}, {"gaps", "2"}},
                           {{"half_width", "0.05"}},
                           {600, 60}},
                    Sealed{"blind",
                           {{"links", "1"}, {"half_width", "-0.08"}, {"shape", "superellipse"}},
                           {{"half_width", "0.05"}},
                           {600, 60}},
                    Sealed{"mixed", {{"links", "2"}, {"sealed", "true"}}, {{"sealed", "false"}}, {400, 100}},
                    Sealed{"mixed", {{"links", "3"}, {"sealed", "true"}}, {{"sealed", "false"}}, {300, 20, 20}}));

// In two joints the cells are fine enough to see the way itself.
TEST(JointCells, FreeOnesJoinTheEndsOfAnOpenPassage)
{
    const Sealed blind{"blind", {{"links", "1"}, {"half_width", "0.05"}}, {}, {}};
    for (int seed = 1; seed <= 5; ++seed)
    {
        const ArmScene scene = draw(blind, seed);
        const PlanarModel model = modelOf(scene);
        EXPECT_TRUE(JointCells(model, {600, 600}).join(scene.start, scene.goal)) << "seed " << seed;
        EXPECT_FALSE(JointCells(model, {60, 60}).join(scene.start, scene.goal)) << "too coarse to be sure";
    }
}

// What they say of a cell holds for configurations in it, by the checker that planners ask.
TEST(JointCells, AreWhatTheySay)
{
    std::mt19937_64 engine(1);
    std::array<int, 3> seen{};
    for (const char *links : {"2", "3"})
    {
        const ArmScene scene = draw({"mixed", {{"links", links}, {"min_obstacles", "8"}}, {}, {}}, 3);
        const PlanarModel model = modelOf(scene);
        const JointCells cells(model, std::vector<int>(scene.lengths.size(), 60));
        const auto checker = makeArmChecker("analytic", model);
        for (int i = 0; i < 50000; ++i)
        {
            Eigen::VectorXd q(model.arm.dimension());
            for (double &angle : q)
                angle = std::uniform_real_distribution<double>(-10.0, 10.0)(engine);
            const JointCells::Cell cell = cells.at(q);
            ++seen[static_cast<std::size_t>(cell)];
            if (cell == JointCells::Cell::Open)
                continue;
            ASSERT_EQ(checker->isFree(q), cell == JointCells::Cell::Free) << q.transpose();
        }
    }
    EXPECT_THAT(seen, testing::Each(testing::Gt(1000)));
}

TEST(Infeasible, AClaimedPathIsRefused)
{
    const ArmScene scene = draw({"mixed", {{"links", "3"}, {"sealed", "true"}}, {}, {}}, 1);
    const Scenario scenario = read(scene);
    Eigen::VectorXd around = scene.goal;
    around[0] += scene.goal[0] > scene.start[0] ? -2.0 * M_PI : 2.0 * M_PI;  // the other way round
    for (const Eigen::VectorXd &end : {scene.goal, around})
    {
        const Verdict verdict = verify(scenario.world, {scene.start, end});
        EXPECT_FALSE(verdict.accepted);
        EXPECT_EQ(verdict.reason, "collision");
    }
}

TEST(Infeasible, NoPlannerSolvesIt)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const Sealed kinds[] = {{"mixed", {{"links", "3"}, {"sealed", "true"}}, {}, {}},
                            {"blind", {{"links", "2"}, {"half_width", "-0.01"}}, {}, {}}};
    for (const Sealed &kind : kinds)
        for (const char *name : {"threader", "hppm", "rrtconnect", "bkpiece1", "sbl"})
            for (unsigned int seed = 1; seed <= 3; ++seed)
            {
                ompl::RNG::setSeed(seed);
                const Problem problem = makeProblem(read(draw(kind, static_cast<int>(seed))));
                const ob::PlannerPtr planner = makePlanner(name, problem.context, {});
                planner->setProblemDefinition(problem.pdef);
                planner->setup();
                int asked = 0;
                planner->solve(ob::PlannerTerminationCondition([&asked] { return ++asked > 3000; }));
                EXPECT_FALSE(problem.pdef->hasExactSolution()) << kind.family << ", " << name << ", seed " << seed;
            }
}

std::string faultOf(const std::string &text)
{
    try
    {
        parseScenario(text, "scene");
    }
    catch (const InputError &error)
    {
        return error.what();
    }
    return "";
}

const std::string wall = "obstacles: [{name: W, kind: box, min: [-0.1, 0.5], max: [0.1, 3]}]\n";
const std::string chain =
    "format: narrows/scenario/1\nname: wall\nrobot:\n  kind: planar_chain\n"
    "  base: {origin: [-2, 1], slide: {axis: [1, 0], limits: [-1, 5]}}\n  links: [{length: 1}]\n" +
    wall + "start: {slide: 0, angles: [0]}\ngoal: {slide: 4, angles: [0]}\n";
const std::string arm = "format: narrows/scenario/1\nname: wall\nrobot: {kind: planar_arm, links: [{length: 1}]}\n" +
                        wall + "start: {angles: [0]}\ngoal: {angles: [180 deg]}\n";

TEST(Infeasible, ProofsAreCheckedWhenFilesAreRead)
{
    EXPECT_EQ(faultOf(chain + "infeasible: {first_joint: [-1, 2]}\n"), "");
    EXPECT_EQ(faultOf(chain + "infeasible: {first_joint: [-3, 1.95]}\n"), "");
    EXPECT_THAT(
        faultOf(chain + "infeasible: {first_joint: [-1, 1.8]}\n"),
        HasSubstr(
            "scene:10: infeasible: proves nothing: nothing stops the first joint at 1.8: (-0.2, 1) is in no obstacle"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [-0.5, 2]}\n"), HasSubstr("nothing stops"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [0.5, 2]}\n"), HasSubstr("the start's first joint, 0, is"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [-1, 4.5]}\n"), HasSubstr("the goal's first joint, 4, is"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [-1, 2], along: [0, 0.5]}\n"),
                HasSubstr("there is no point 0.5 from the base"));
}

// One wall does not stop a joint that turns freely: the other way round leads there too.
TEST(Infeasible, AngleNeedsBothEnds)
{
    EXPECT_THAT(faultOf(arm + "infeasible: {first_joint: [-270 deg, 90 deg], along: [0.75, 0.75]}\n"),
                HasSubstr("is not outside of"));
    EXPECT_THAT(faultOf(arm + "infeasible: {first_joint: [-90 deg, 90 deg], along: [0.75, 0.75]}\n"),
                HasSubstr("nothing stops the first joint at -1.57"));
    const std::string limited =
        "format: narrows/scenario/1\nname: wall\n"
        "robot: {kind: planar_arm, links: [{length: 1}], limits: [-10 deg, 200 deg]}\n" +
        wall + "start: {angles: [0]}\ngoal: {angles: [180 deg]}\n";
    EXPECT_EQ(faultOf(limited + "infeasible: {first_joint: [-10 deg, 90 deg], along: [0, 0.75]}\n"), "");
    EXPECT_THAT(faultOf(limited + "infeasible: {first_joint: [-10 deg, 90 deg], along: [0, 0.25]}\n"),
                HasSubstr("nothing stops the first joint at 1.57"));
}

TEST(Infeasible, SaysWhatItCannotRead)
{
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [2, -1]}\n"), HasSubstr("infeasible.first_joint"));
    EXPECT_THAT(faultOf(chain + "infeasible: {along: [0, 0]}\n"), HasSubstr("infeasible.first_joint: is missing"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [-1, 2], along: [0]}\n"), HasSubstr("infeasible.along"));
    EXPECT_THAT(faultOf(chain + "infeasible: {first_joint: [-1, 2], why: wall}\n"), HasSubstr("infeasible.why"));
    EXPECT_THAT(
        faultOf("format: narrows/scenario/1\nname: n\ngenerate: {family: blind}\ninfeasible: {first_joint: [0, 1]}\n"),
        HasSubstr("generate makes robot, obstacles, start and goal"));
    EXPECT_THROW(draw({"blind", {{"half_width", "0"}}, {}, {}}, 1), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
