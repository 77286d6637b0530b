// SPDX-License-Identifier: BSD-3-Clause
// bent_tube, blind, mixed, cut, horn, maze, holes, slot, and the shapes beside gaps.
#include <cmath>
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/Scenario.h"
#include "scenario/families/Family.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using testing::HasSubstr;
using Texts = std::map<std::string, std::string>;

/// Scenes per case: NARROWS_FAMILY_INSTANCES=1000 makes these tests the long ones.
int instances(int otherwise)
{
    const char *asked = std::getenv("NARROWS_FAMILY_INSTANCES");
    return asked != nullptr ? std::atoi(asked) : otherwise;
}

ArmScene draw(const std::string &family, Texts given, int seed = 0)
{
    if (seed > 0)
        given["seed"] = std::to_string(seed);
    return std::get<ArmScene>(findFamily(family).draw(findFamily(family).values(given)));
}

SpaceScene drawInSpace(const std::string &family, Texts given, int seed)
{
    given["seed"] = std::to_string(seed);
    return std::get<SpaceScene>(findFamily(family).draw(findFamily(family).values(given)));
}

/// Reads the file of the scene, and judges its witness against that.
template <class AnyScene>
Verdict judgeWitness(const AnyScene &scene)
{
    const Scenario scenario = parseScenario(toYaml(scene, "scene", "test"), "scene");
    return verify(scenario.world, scene.witness);
}

template <class AnyScene>
void expectWitness(const AnyScene &scene)
{
    ASSERT_FALSE(scene.witness.empty());
    EXPECT_EQ(scene.witness.front(), scene.start);
    EXPECT_EQ(scene.witness.back(), scene.goal);
    const Verdict verdict = judgeWitness(scene);
    EXPECT_TRUE(verdict.accepted) << verdict.reason << ", segment " << verdict.segment << ", " << verdict.obstacle;
    EXPECT_EQ(judgeMotion(scene, scene.start, scene.goal), Motion::Blocked);
}

// Whole files: see FamilyTest.cpp.
TEST(PassageFamilies, DrawTheSameFilesEverywhere)
{
    for (const char *name : {"bent_tube", "blind", "cut", "holes", "horn", "maze", "mixed", "slot"})
    {
        const Family &family = findFamily(name);
        const FamilyValues values = family.values({});
        const Scenario stored = readScenario(NARROWS_SOURCE_DIR "/tests/data/families/" + std::string(name) + ".yaml");
        EXPECT_EQ(toYaml(family.draw(values), name, family.describe(values)), stored.text);
    }
}

struct Passage
{
    std::string family;
    Texts parameters;
};

void PrintTo(const Passage &passage, std::ostream *out)
{
    *out << passage.family;
    for (const auto &[key, value] : passage.parameters)
        *out << " " << key << " " << value;
}

class Passages : public testing::TestWithParam<Passage>
{
};

TEST_P(Passages, HaveAWitnessAndABlockedLine)
{
    const auto &[family, parameters] = GetParam();
    std::set<std::string> texts;
    const int count = instances(20);
    for (int seed = 1; seed <= count; ++seed)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const ArmScene scene = draw(family, parameters, seed);
        expectWitness(scene);
        texts.insert(toYaml(scene, "scene", "test"));
        EXPECT_EQ(texts.count(toYaml(draw(family, parameters, seed), "scene", "test")), 1u) << "same seed, same file";
    }
    // There are not so many mazes but that some come twice.
    EXPECT_GE(texts.size(), static_cast<std::size_t>(family == "maze" ? 0.8 * count : count))
        << "other seeds, other files";
}

INSTANTIATE_TEST_SUITE_P(
    Families, Passages,
    testing::Values(Passage{"bent_tube", {}}, Passage{"bent_tube", {{"links", "16"}, {"half_width", "1e-4"}}},
                    Passage{"bent_tube", {{"links", "5"}, {"half_width", "1e-3"}, {"bend", "0.6"}}},
                    Passage{"bent_tube", {{"half_width", "1e-3"}, {"shape", "polygon"}}},
                    Passage{"bent_tube", {{"half_width", "1e-3"}, {"shape", "superellipse"}}},
                    Passage{"bent_tube", {{"half_width", "1e-3"}, {"shape", "box"}}},
                    Passage{"tube", {{"links", "16"}, {"gaps", "3"}, {"half_width", "1e-3"}}},
                    Passage{"tube", {{"links", "8"}, {"half_width", "1e-4"}, {"shape", "box"}}},
                    Passage{"slab", {{"links", "6"}, {"half_width", "1e-3"}, {"shape", "superellipse"}}},
                    Passage{"slab", {{"links", "6"}, {"half_width", "1e-6"}, {"shape", "polygon"}}},
                    Passage{"blind", {}}, Passage{"blind", {{"links", "8"}, {"gaps", "3"}, {"half_width", "1e-4"}}},
                    Passage{"blind", {{"links", "5"}, {"half_width", "1e-6"}, {"shape", "superellipse"}}},
                    Passage{"maze", {}}, Passage{"maze", {{"links", "5"}, {"thickness", "0.4"}}},
                    Passage{"maze", {{"links", "80"}, {"columns", "8"}, {"rows", "6"}, {"braid", "0.5"}}},
                    Passage{"mixed", {{"links", "3"}}}, Passage{"mixed", {{"links", "10"}}}));

class PassagesInSpace : public testing::TestWithParam<Passage>
{
};

TEST_P(PassagesInSpace, HaveAWitnessABlockedLineAndTheClearanceAskedFor)
{
    const auto &[family, parameters] = GetParam();
    std::set<std::string> texts;
    const int count = instances(5);
    for (int seed = 1; seed <= count; ++seed)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const SpaceScene scene = drawInSpace(family, parameters, seed);
        expectWitness(scene);
        // Goals are rounded to 11 decimals of a radian.
        EXPECT_NEAR(clearance(scene, scene.goal), std::stod(parameters.at("half_width")), 1e-10);
        texts.insert(toYaml(scene, "scene", "test"));
        EXPECT_EQ(texts.count(toYaml(drawInSpace(family, parameters, seed), "scene", "test")), 1u);
    }
    EXPECT_EQ(texts.size(), static_cast<std::size_t>(count)) << "other seeds, other files";
}

INSTANTIATE_TEST_SUITE_P(Families, PassagesInSpace,
                         testing::Values(Passage{"holes", {{"half_width", "0.01"}}},
                                         Passage{"holes", {{"half_width", "1e-3"}, {"holes", "1"}, {"radius", "0"}}},
                                         Passage{"slot", {{"half_width", "0.01"}}},
                                         Passage{"slot", {{"half_width", "1e-3"}, {"opening", "hole"}}},
                                         Passage{"slot", {{"half_width", "1e-3"}, {"opening", "box"}}}));

class Shapes : public testing::TestWithParam<const char *>
{
};

// The gap is what it is said to be: each of its sides is as far from the arm as the other, to the rounding of files.
TEST_P(Shapes, TouchTheGapsEdges)
{
    for (const char *family : {"slab", "tube", "bent_tube"})
        for (int seed = 1; seed <= 10; ++seed)
        {
            const Texts given{{"links", "8"}, {"half_width", "0.02"}, {"shape", GetParam()}};
            const ArmScene scene = draw(family, given, seed);
            for (const PlanarObstacle &obstacle : scene.obstacles)
            {
                ArmScene alone = scene;
                alone.obstacles = {obstacle};
                // A tilted line's angle is rounded once more, to 6 decimals, before the obstacles are placed along it.
                EXPECT_NEAR(clearance(alone, scene.goal), 0.02, 2e-11) << family << ", seed " << seed;
            }
        }
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::Values("circle", "box", "superellipse", "polygon"));

TEST(Shapes, AreCirclesUnlessTold)
{
    EXPECT_EQ(draw("slab", {}).obstacles[0].shape.index(), 0u);
    EXPECT_EQ(toYaml(draw("slab", {}), "n", "s"), toYaml(draw("slab", {{"shape", "circle"}}), "n", "s"));
    EXPECT_THAT(toYaml(draw("slab", {{"shape", "box"}}), "n", "s"), HasSubstr("kind: polygon"));
    EXPECT_THAT(toYaml(draw("slab", {{"shape", "superellipse"}}), "n", "s"), HasSubstr("kind: superellipse"));
    EXPECT_THROW(draw("slab", {{"shape", "egg"}}), std::invalid_argument);
}

// What makes the tube a bent one: the last rod lies at the angle asked for, and both rods are in their gaps.
TEST(BentTube, TheSecondGapIsTilted)
{
    for (int seed = 1; seed <= 10; ++seed)
    {
        const ArmScene scene = draw("bent_tube", {{"bend", "0.5"}}, seed);
        EXPECT_NEAR(std::abs(scene.goal[7] - scene.goal[5]), 0.5, 1e-9);
        EXPECT_EQ(scene.goal[4], scene.goal[5]);
        EXPECT_EQ(scene.goal[6], scene.goal[7]);
        const Eigen::Vector2d first =
            std::get<Circle>(scene.obstacles[0].shape).center - std::get<Circle>(scene.obstacles[1].shape).center;
        const Eigen::Vector2d second =
            std::get<Circle>(scene.obstacles[2].shape).center - std::get<Circle>(scene.obstacles[3].shape).center;
        EXPECT_NEAR(first.normalized().dot(second.normalized()), std::cos(0.5), 1e-9);
    }
}

TEST(BentTube, SaysWhenNothingCanTurnBetweenTheGaps)
{
    EXPECT_THROW(draw("bent_tube", {{"links", "5"}, {"depth", "0.6"}}), std::invalid_argument);
}

// No link crosses a wall's line at either end of the problem, and the base has to.
TEST(Blind, BothEndsAreOutside)
{
    for (int seed = 1; seed <= 20; ++seed)
    {
        const ArmScene scene = draw("blind", {{"links", "4"}, {"gaps", "2"}}, seed);
        const PlanarModel model = modelOf(scene);
        const auto along = [&](const Eigen::VectorXd &q)
        {
            std::vector<Eigen::Vector2d> points;
            model.arm.place(q, points);
            std::vector<double> places;
            for (const Eigen::Vector2d &point : points)
                places.push_back(point.dot(scene.slide->axis));
            return places;
        };
        EXPECT_THAT(along(scene.start), testing::Each(testing::Lt(0.0)));
        EXPECT_THAT(along(scene.goal), testing::Each(testing::Gt(0.8)));
    }
}

TEST(Mixed, HasAllKindsOfObstaclesAndKeepsItsPromises)
{
    std::set<std::size_t> kinds;
    for (int seed = 1; seed <= 40; ++seed)
        for (const char *witness : {"true", "false"})
        {
            const ArmScene scene = draw("mixed", {{"witness", witness}}, seed);
            EXPECT_GE(scene.obstacles.size(), 3u);
            EXPECT_LE(scene.obstacles.size(), 8u);
            for (const PlanarObstacle &obstacle : scene.obstacles)
                kinds.insert(obstacle.shape.index());
            EXPECT_GT(clearance(scene, scene.start), 0.03);
            EXPECT_GT(clearance(scene, scene.goal), 0.03);
            EXPECT_EQ(judgeMotion(scene, scene.start, scene.goal), Motion::Blocked);
            EXPECT_EQ(scene.witness.empty(), std::string(witness) == "false");
        }
    EXPECT_EQ(kinds.size(), 3u);
    EXPECT_THROW(draw("mixed", {{"min_obstacles", "9"}}), std::invalid_argument);
}

TEST(Cut, IsThePapersThirdCaseInPieces)
{
    const Scenario paper = readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/hppm_case3.yaml");
    const PlanarModel &model = *paper.planar().model;
    for (const char *pieces : {"1", "2", "4", "8"})
    {
        const ArmScene scene = draw("cut", {{"pieces", pieces}});
        const int k = std::atoi(pieces);
        ASSERT_EQ(scene.lengths.size(), 20u * k);
        EXPECT_NEAR(scene.lengths[0] * k, model.arm.links()[0].length, 1e-15);
        for (Eigen::Index i = 0; i < scene.goal.size(); ++i)
        {
            EXPECT_NEAR(scene.start[i], paper.planar().task.start[i / k], 1e-14);
            EXPECT_NEAR(scene.goal[i], std::get<Eigen::VectorXd>(paper.planar().task.goal)[i / k], 1e-14);
        }
        ASSERT_EQ(scene.obstacles.size(), model.obstacles.size());
        for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
        {
            const Bounds ours = bounds(scene.obstacles[i]), printed = bounds(model.obstacles[i]);
            EXPECT_NEAR((ours.lower - printed.lower).norm() + (ours.upper - printed.upper).norm(), 0.0, 1e-11);
        }
        expectWitness(scene);
        EXPECT_NEAR(judgeWitness(scene).clearance, 0.005, 1.5e-4);
    }
}

// A perfect maze of n cells has n - 1 doors; each of the other sides is a wall, but for the entrance.
TEST(Maze, IsPerfectUnlessBraided)
{
    for (int seed = 1; seed <= 10; ++seed)
    {
        const auto walls = [&](const char *braid)
        {
            return draw("maze", {{"columns", "6"}, {"rows", "4"}, {"braid", braid}}, seed).obstacles.size();
        };
        EXPECT_EQ(walls("0"), 2u * (6 + 4) - 1u + 5 * 4 + 6 * 3 - (6 * 4 - 1));
        EXPECT_LT(walls("1"), walls("0"));
    }
}

TEST(Maze, TheChainLiesInTheMazeAtTheGoalAndBeforeItAtTheStart)
{
    const ArmScene scene = draw("maze", {{"links", "30"}}, 3);
    std::vector<Eigen::Vector2d> points;
    modelOf(scene).arm.place(scene.start, points);
    for (const Eigen::Vector2d &point : points)
        EXPECT_LT(point.x(), -0.1);
    modelOf(scene).arm.place(scene.goal, points);
    EXPECT_EQ(points.front(), Eigen::Vector2d::Zero());
    for (const Eigen::Vector2d &point : points)  // joints are on the middle line, through the middles of cells
        EXPECT_NEAR(std::min(std::abs(std::remainder(point.x() - 0.5, 1.0)), std::abs(std::remainder(point.y(), 1.0))),
                    0.0, 1e-6);
}

// OMPL's demo: n links of 1/n, relative angles 0, pi/n, pi/n, ... at the start and pi - 0.001, 0, 0, ... at the goal;
// the walls' inner faces are chains of n - 1 pieces of length (1 +- pi w) / n that begin at (1/n, -+w).
TEST(Horn, IsTheDemosWithThickWalls)
{
    for (const int links : {5, 10, 20})
    {
        const ArmScene scene = draw("horn", {{"links", std::to_string(links)}});
        const Scenario scenario = parseScenario(toYaml(scene, "horn", "test"), "horn");
        const PlanarWorld &world = scenario.planar();
        EXPECT_EQ(world.convention, AngleConvention::Relative);
        EXPECT_TRUE(world.model->selfCollision);
        const Eigen::VectorXd start = world.model->arm.fromAbsolute(world.task.start, AngleConvention::Relative);
        const Eigen::VectorXd goal =
            world.model->arm.fromAbsolute(std::get<Eigen::VectorXd>(world.task.goal), AngleConvention::Relative);
        for (Eigen::Index i = 0; i < links; ++i)
        {
            EXPECT_NEAR(start[i], i == 0 ? 0.0 : M_PI / links, 1e-11);
            EXPECT_NEAR(goal[i], i == 0 ? M_PI - 1e-3 : 0.0, 1e-11);
        }
        const double width = std::log(double(links)) / links;
        const auto &outer = std::get<Polygon>(scene.obstacles[0].shape);
        ASSERT_EQ(outer.vertices.size(), 2u * links);
        const Eigen::Vector2d begin = outer.vertices.back();  // counter-clockwise: the inner face comes last, backwards
        EXPECT_NEAR((begin - Eigen::Vector2d(1.0 / links, -width)).norm(), 0.0, 1e-11);
        EXPECT_NEAR((outer.vertices[2 * links - 2] - begin).norm(), (1.0 + M_PI * width) / links, 1e-11);
        EXPECT_EQ(scene.obstacles[1].shape.index(), links > 5 ? 2u : 0u);
        EXPECT_EQ(judgeMotion(scene, scene.start, scene.goal), Motion::Blocked);
    }
}
}  // namespace
}  // namespace narrows
