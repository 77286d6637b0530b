// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "LadderScenes.h"
#include "TightScenes.h"
#include "kernel/JointCentres.h"
#include "scenario/Scenario.h"
#include "scenario/families/DuctWalk.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;
using Texts = std::map<std::string, std::string>;

template <int D>
ChainScene<D> drawChain(const std::string &family, const Texts &given = {})
{
    return std::get<ChainScene<D>>(findFamily(family).draw(findFamily(family).values(given)));
}

template <int D>
double volumeOf(const std::vector<AxisBox<D>> &boxes)
{
    double volume = 0.0;
    for (const AxisBox<D> &box : boxes)
        volume += box.volume();
    return volume;
}

template <int D>
int countContaining(const std::vector<AxisBox<D>> &boxes, const Eigen::Matrix<double, D, 1> &point)
{
    return static_cast<int>(
        std::count_if(boxes.begin(), boxes.end(), [&point](const AxisBox<D> &box) { return box.contains(point); }));
}

TEST(RoomWalls, AreTheSolidWithoutTheRooms)
{
    RandomNumbers random(3);
    const AxisBox<3> solid{{0, 0, 0}, {10, 10, 10}};
    for (int trial = 0; trial < 20; ++trial)
    {
        std::vector<AxisBox<3>> rooms;
        for (int i = 0; i < 6; ++i)
        {
            Vector3d lower, size;
            for (int axis = 0; axis < 3; ++axis)
            {
                lower[axis] = random.whole(-2, 9);
                size[axis] = random.whole(1, 5);
            }
            rooms.push_back({lower, lower + size});
        }
        const std::vector<AxisBox<3>> walls = wallsAround<3>(rooms, solid);
        double solidCubes = 0.0;
        for (int cube = 0; cube < 1000; ++cube)
        {
            const Vector3d center(cube % 10 + 0.5, cube / 10 % 10 + 0.5, cube / 100 + 0.5);
            const bool isFree = countContaining<3>(rooms, center) > 0;
            EXPECT_EQ(countContaining<3>(walls, center), isFree ? 0 : 1);
            solidCubes += isFree ? 0.0 : 1.0;
        }
        EXPECT_EQ(volumeOf<3>(walls), solidCubes);
    }
}

TEST(ChainScene, BendFormulaIsThatOfALinkTouchingThreeWalls)
{
    EXPECT_NEAR(longestLinkAtBend(200.0, 0.0), 2.0 * std::sqrt(2.0) * 200.0, 1e-9);
    EXPECT_NEAR(longestLinkAtBend(200.0, 5.0), 541.5, 0.1);
    EXPECT_NEAR(longestLinkAtBend(40.0, 2.0), 103.48, 0.01);
    // At 45 degrees, both ends at the outer walls, the inner corner (w, 0) of the walls x = 0, y = w a radius away.
    const double width = 200.0, radius = 5.0, length = longestLinkAtBend(width, radius);
    const Vector2d front(radius + length * M_SQRT1_2, width - radius);
    const Vector2d normal(-M_SQRT1_2, M_SQRT1_2);
    EXPECT_NEAR(std::abs(normal.dot(Vector2d(width, 0.0) - front)), radius, 1e-9);
}

TEST(LadderFamily, ChainsWaitStraightAtTheEntrance)
{
    for (const std::string &shape : findFamily("ladder").parameter("shape").names)
    {
        const ChainScene<2> scene = ladderScene(shape, 400.0);
        const Scenario scenario = parseScenario(toYaml(scene, "ladder", shape), shape);
        const PlanarWorld &world = scenario.planar();
        EXPECT_EQ(world.model->obstacles.size(), scene.walls.size()) << shape;
        EXPECT_TRUE(world.model->selfCollision);
        EXPECT_EQ(world.task.start.size(), scene.links + 1);
        EXPECT_NEAR(world.task.start[0], -scene.reach(), 1e-9);
        for (int i = 1; i <= scene.links; ++i)
            EXPECT_DOUBLE_EQ(world.task.start[i], M_PI / 2.0);
        EXPECT_GE(scene.reach(), 2000.0);
        const auto distance = signedDistance<2>(scene.walls);
        EXPECT_GE(distance(scene.entrance), 99.0) << shape;
        EXPECT_GE(distance(scene.goal), 50.0) << shape;
    }
}

TEST(LadderFamily, ShapesAreNamed)
{
    try
    {
        findFamily("ladder").values({{"shape", "U41"}});
        FAIL() << "there is no such shape";
    }
    catch (const std::invalid_argument &error)
    {
        EXPECT_STREQ(error.what(), "shape: must be one of L, U40, S3, Z300, Z600, trap22, corner200x115, not 'U41'");
    }
    EXPECT_NE(findFamily("ladder").describe(findFamily("ladder").values({})).find("shape L, length 350"),
              std::string::npos);
}

TEST(LadderFamily, TheUTurnIsTheOneOfTheFindings)
{
    const VoxelGrid<2> rooms = uTurn(10.0);
    const auto distance = signedDistance<2>(ladderScene("U40").walls);
    for (int cell = 0; cell < rooms.cells(); ++cell)
        EXPECT_EQ(rooms.occupied(cell), distance(rooms.center(cell)) < 0.0);
}

TEST(LadderFamily, JointLimitsAreReadBack)
{
    ChainScene<2> scene = ladderScene("L");
    scene.maxAngle = 60.0;
    const JointLimits limits = parseScenario(toYaml(scene, "L", "x"), "L").planar().task.limits;
    EXPECT_EQ(limits.convention, AngleConvention::Relative);
    EXPECT_NEAR(limits.angles[0]->lower, M_PI / 6.0, 1e-12);
    EXPECT_NEAR(limits.angles[1]->upper, M_PI / 3.0, 1e-12);
}

TEST(MazeFamily, IsTheSolidAroundThirteenBends)
{
    const ChainScene<3> scene = drawChain<3>("maze3d");
    EXPECT_EQ(scene.links, 35);
    EXPECT_EQ(scene.walls.size(), 31u);
    const VoxelGrid<3> rooms = bentPipe(10.0, 240.0);
    for (int cell = 0; cell < rooms.cells(); ++cell)
        EXPECT_EQ(countContaining<3>(scene.walls, rooms.center(cell)), rooms.occupied(cell) ? 1 : 0);
    const Scenario scenario = parseScenario(toYaml(scene, "maze", "x"), "maze");
    const auto chain = chainGeometry(scenario.spatial().model->arm);
    ASSERT_TRUE(chain.has_value());
    EXPECT_EQ(chain->origin, scene.entrance);
    EXPECT_NEAR(chain->maxAngle, 88.0 * M_PI / 180.0, 1e-12);
    EXPECT_NEAR(scenario.spatial().task.start[0], -35.0 * 84.0, 1e-9);
}

TEST(MazeFamily, PutsTheGoalWhereAShareOfTheChainIsInTheDuct)
{
    const auto goal = [](const std::string &links, const std::string &fed)
    {
        return drawChain<3>("maze3d", {{"links", links}, {"length", "100"}, {"fed", fed}}).goal;
    };
    // The duct begins at x = 240, its first bend is at x = 320, the second one 240 up.
    EXPECT_EQ(goal("1", "0.5"), Vector3d(290, 240, 60));
    EXPECT_EQ(goal("2", "1"), Vector3d(320, 240, 180));
    EXPECT_EQ(goal("4", "1"), Vector3d(320, 320, 300));
    EXPECT_EQ(goal("100", "1"), Vector3d(800, 300, 400));
}

TEST(BoxesFamily, AreTheBoxesOfTheFindings)
{
    const ChainScene<3> scene = drawChain<3>("boxes3d");
    const std::vector<SpatialObstacle> boxes = clutter(700);
    const std::size_t sides = scene.walls.size() - boxes.size();
    EXPECT_EQ(sides, 5u);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        const auto &box = std::get<Box>(boxes[i].shape);
        EXPECT_EQ(scene.walls[sides + i].lower, box.pose.translation() - box.halfExtents);
        EXPECT_EQ(scene.walls[sides + i].upper, box.pose.translation() + box.halfExtents);
    }
}

TEST(DuctFamily, BendsAtRightAnglesAndKeepsApart)
{
    const DuctLattice lattice{{0, 0, 0}, {0, -6, -6}, {12, 6, 6}};
    int planes = 0;
    for (int seed = 1; seed <= 50; ++seed)
    {
        RandomNumbers random(static_cast<std::uint64_t>(seed));
        const std::vector<Vector3d> line = drawDuct(random, 8, lattice);
        ASSERT_EQ(line.size(), 10u);
        double volume = 0.0;
        for (std::size_t i = 1; i < line.size(); ++i)
        {
            const Vector3d piece = line[i] - line[i - 1];
            EXPECT_EQ(piece.cwiseAbs().maxCoeff(), piece.norm()) << "along an axis";
            EXPECT_GE(piece.norm(), 120.0);
            EXPECT_LE(piece.norm(), 240.0);
            if (i > 1)
            {
                EXPECT_EQ(piece.dot(line[i - 1] - line[i - 2]), 0.0);
            }
            if (i > 2)
                planes += std::abs(piece.dot((line[i - 1] - line[i - 2]).cross(line[i - 2] - line[i - 3]))) > 0.0;
            volume += 40.0 * 40.0 * piece.norm();
        }
        // The rooms meet only where they follow each other: nothing is counted twice but the bends.
        const AxisBox<3> solid{{-100, -500, -500}, {900, 500, 500}};
        const double cut = solid.volume() - volumeOf<3>(wallsAround<3>(ductAlong(line), solid));
        EXPECT_NEAR(cut, volume + 40.0 * 40.0 * 40.0, 1e-3) << seed;
    }
    EXPECT_GT(planes, 100) << "of 350 pairs of bends that follow each other";
}

TEST(DuctFamily, ScenesAreReadAndTheSameForTheSameSeed)
{
    for (int seed = 1; seed <= 10; ++seed)
    {
        const Texts given{{"seed", std::to_string(seed)}, {"index", "0.8"}};
        const ChainScene<3> scene = drawChain<3>("pipe3d", given);
        EXPECT_NEAR(scene.length, 0.8 * longestLinkAtBend(40.0, 2.0), 1e-6);
        const std::string text = toYaml(scene, "pipe", "x");
        EXPECT_NO_THROW(parseScenario(text, "pipe")) << seed;
        EXPECT_EQ(text, toYaml(drawChain<3>("pipe3d", given), "pipe", "x"));
        EXPECT_NE(text, toYaml(drawChain<3>("pipe3d", {{"seed", "99"}, {"index", "0.8"}}), "pipe", "x"));
    }
}

TEST(ClutterFamily, KeepsADuctFreeFromTheEntranceToTheGoal)
{
    for (int seed = 1; seed <= 5; ++seed)
    {
        const ChainScene<3> scene = drawChain<3>("clutter3d", {{"seed", std::to_string(seed)}});
        EXPECT_EQ(scene.walls.size(), 705u);
        RandomNumbers random(static_cast<std::uint64_t>(seed));
        const std::vector<Vector3d> line = drawDuct(random, 4, {{120.0, 240.0, 240.0}, {0, -3, -3}, {10, 3, 3}});
        EXPECT_EQ(scene.goal, line.back());
        const std::vector<AxisBox<3>> duct = ductAlong(line);
        for (const AxisBox<3> &piece : duct)
            for (const AxisBox<3> &wall : scene.walls)
                EXPECT_GE((wall.lower - piece.upper).cwiseMax(piece.lower - wall.upper).maxCoeff(), 0.0);
        EXPECT_NO_THROW(parseScenario(toYaml(scene, "clutter", "x"), "clutter"));
    }
}
}  // namespace
}  // namespace narrows
