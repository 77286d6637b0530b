// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/Scenario.h"
#include "validity/ArmChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

const std::string folder = NARROWS_SOURCE_DIR "/experiments/scenarios/";
const std::string meshes = NARROWS_SOURCE_DIR "/tests/data/meshes/";

/// A file with one universal link and one obstacle out of the way; the arguments replace its parts.
Scenario small(const std::string &obstacles, const std::string &robot = "links: [{length: 1}]",
               const std::string &start = "{joints: [[0, 0]]}",
               const std::string &goal = "{tip: [0, 0, 1], tolerance: 0.1}", const std::string &file = meshes + "text")
{
    return parseScenario("format: narrows/scenario/1\nname: small\nrobot: {kind: spatial_arm, " + robot +
                             "}\nobstacles: " + obstacles + "\nstart: " + start + "\ngoal: " + goal + "\n",
                         file);
}

template <class Shape>
Shape onlyShape(const Scenario &scenario)
{
    return std::get<Shape>(scenario.spatial().model->obstacles.at(0).shape);
}

Vector3d tipOf(const SpatialArm &arm, const VectorXd &q)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement.points.back();
}

/// The volume that a surface encloses; positive if its normals point outwards.
double volume(const Mesh &mesh)
{
    double sum = 0.0;
    for (const std::array<int, 3> &t : mesh.triangles)
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
    return sum;
}

const VectorXd &goalState(const Scenario &scenario)
{
    return std::get<VectorXd>(scenario.spatial().task.goal);
}

/// Start and goal are free with some room, and the straight motion between them is not.
void expectBlocked(const std::string &name, double room)
{
    const Scenario scenario = readScenario(folder + name);
    const SpatialWorld &world = scenario.spatial();
    for (const char *kind : {"analytic", "fcl"})
    {
        const auto checker = makeArmChecker(kind, *world.model);
        EXPECT_GT(checker->clearance(world.task.start), room) << kind;
        EXPECT_GT(checker->clearance(goalState(scenario)), room) << kind;
        std::uint64_t placements = 0;
        EXPECT_FALSE(checker->isMotionFree(world.task.start, goalState(scenario) - world.task.start, placements))
            << kind;
    }
}

TEST(SpatialScenarioReader, TheProjectsScenariosAreFreeAtTheirEndsAndBlockedBetween)
{
    expectBlocked("spatial_elbow.yaml", 0.05);
    expectBlocked("spatial_six.yaml", 0.02);
    expectBlocked("spatial_snake.yaml", 0.05);
    expectBlocked("spatial_mesh.yaml", 0.02);
}

TEST(SpatialScenarioReader, ReadsAnArmByDenavitAndHartenberg)
{
    const Scenario scenario = readScenario(folder + "spatial_elbow.yaml");
    EXPECT_FALSE(scenario.isPlanar());
    EXPECT_TRUE(scenario.spatial().model->selfCollision);
    const SpatialArm &arm = scenario.spatial().model->arm;
    ASSERT_EQ(arm.dimension(), 3);
    ASSERT_EQ(arm.linkCount(), 3);
    EXPECT_EQ(arm.links()[0].radius, 0.08);
    EXPECT_EQ(arm.links()[1].radius, 0.05) << "the robot's own";
    EXPECT_DOUBLE_EQ(arm.joints()[0].limits->lower, -170.0 * M_PI / 180.0);
    const double yaw = -50.0 * M_PI / 180.0;
    const double out = std::cos(10.0 * M_PI / 180.0) + 0.8 * std::cos(25.0 * M_PI / 180.0);
    const double up = 0.6 + std::sin(10.0 * M_PI / 180.0) - 0.8 * std::sin(25.0 * M_PI / 180.0);
    const Vector3d expected(out * std::cos(yaw), out * std::sin(yaw), up);
    EXPECT_TRUE(tipOf(arm, scenario.spatial().task.start).isApprox(expected, 1e-12));
}

TEST(SpatialScenarioReader, ReadsAChainOfUniversalJoints)
{
    const Scenario scenario = readScenario(folder + "spatial_snake.yaml");
    const SpatialArm &arm = scenario.spatial().model->arm;
    ASSERT_EQ(arm.dimension(), 16);
    ASSERT_EQ(arm.universalLimits().size(), 8u);
    EXPECT_DOUBLE_EQ(arm.universalLimits()[7].maxAngle, M_PI / 3.0);
    EXPECT_EQ(arm.links()[0].radius, 0.04);
    const VectorXd &start = scenario.spatial().task.start;
    EXPECT_DOUBLE_EQ(start[0], 10.0 * M_PI / 180.0);
    EXPECT_DOUBLE_EQ(start[1], 50.0 * M_PI / 180.0);
    EXPECT_TRUE(start.isApprox(-goalState(scenario))) << "the goal mirrors the start";
}

TEST(SpatialScenarioReader, ReadsASlideAndATipGoal)
{
    const Scenario scenario =
        small("[]", "base: {origin: [1, 2, 3], slide: {axis: [0, 3, 4], limits: [0, 5]}}, links: [{length: 2}]",
              "{slide: 5, joints: [[0, 90 deg]]}", "{tip: [1, 2, 5], tolerance: 0.25}");
    const SpatialArm &arm = scenario.spatial().model->arm;
    ASSERT_EQ(arm.dimension(), 3);
    EXPECT_TRUE(tipOf(arm, scenario.spatial().task.start).isApprox(Vector3d(1.0, 2.0 + 3.0 + 2.0, 3.0 + 4.0), 1e-12));
    const auto &goal = std::get<SpatialTipGoal>(scenario.spatial().task.goal);
    EXPECT_EQ(goal.link, 0);
    EXPECT_EQ(goal.point, Vector3d(1, 2, 5));
    EXPECT_EQ(goal.tolerance, 0.25);
}

TEST(SpatialScenarioReader, TheBaseOfAnArmMayBeTurned)
{
    const Scenario scenario =
        small("[]", "joints: dh, base: {origin: [1, 0, 0], rotation: {axis: y, angle: 90 deg}}, links: [{d: 2}]",
              "{joints: [0]}", "{joints: [1]}");
    EXPECT_TRUE(tipOf(scenario.spatial().model->arm, scenario.spatial().task.start).isApprox(Vector3d(3, 0, 0), 1e-12));
}

TEST(SpatialScenarioReader, ATipGoalCountsTheLinksAsTheFileDoes)
{
    const std::string robot = "joints: dh, links: [{d: 1, a: 1}, {alpha: 90 deg}, {d: 1}, {}]";
    const auto linkOf = [&](const std::string &goal)
    {
        return std::get<SpatialTipGoal>(small("[]", robot, "{joints: [0, 0, 0, 0]}", goal).spatial().task.goal).link;
    };
    EXPECT_EQ(linkOf("{tip: [1, 0, 1], tolerance: 0.1, link: 1}"), 1) << "along a, after the one along d";
    EXPECT_EQ(linkOf("{tip: [1, 0, 1], tolerance: 0.1, link: 3}"), 2);
    EXPECT_EQ(linkOf("{tip: [1, 0, 1], tolerance: 0.1}"), 2) << "the last that has a length";
}

TEST(SpatialScenarioReader, StatesAtTheLimitAreAccepted)
{
    for (const char *joints : {"[[60 deg, 0]]", "[[0, -60 deg]]", "[[-60 deg, 0 deg]]"})
        EXPECT_NO_THROW(
            small("[]", "max_link_angle: 60 deg, links: [{length: 1}]", std::string("{joints: ") + joints + "}"))
            << joints;
}

TEST(SpatialScenarioReader, ReadsEveryKindOfObstacle)
{
    const auto sphere = onlyShape<Sphere>(small("[{kind: sphere, center: [0, 5, 6], radius: 2}]"));
    EXPECT_EQ(sphere.center, Vector3d(0, 5, 6));
    EXPECT_EQ(sphere.radius, 2.0);

    const auto capsule = onlyShape<Capsule>(small("[{kind: capsule, from: [0, 5, 5], to: [1, 5, 5], radius: 2}]"));
    EXPECT_EQ(capsule.to, Vector3d(1, 5, 5));

    const auto cylinder =
        onlyShape<Cylinder>(small("[{kind: cylinder, center: [9, 9, 9], axis: [0, 3, 4], radius: 2, length: 3}]"));
    EXPECT_TRUE(cylinder.axis.isApprox(Vector3d(0.0, 0.6, 0.8)));
    EXPECT_EQ(cylinder.halfLength, 1.5);
    for (const char *length : {"inf", ".inf"})
        EXPECT_EQ(onlyShape<Cylinder>(small("[{kind: cylinder, center: [0, 5, 5], axis: x, radius: 2, length: " +
                                            std::string(length) + "}]"))
                      .halfLength,
                  std::numeric_limits<double>::infinity());

    const auto box =
        onlyShape<Box>(small("[{kind: box, min: [4, 4, 4], max: [5, 8, 6], rotation: {axis: z, angle: 90 deg}}]"));
    EXPECT_EQ(box.halfExtents, Vector3d(0.5, 2.0, 1.0));
    EXPECT_TRUE((box.pose * Vector3d(0, 2, 0)).isApprox(Vector3d(2.5, 6.0, 5.0), 1e-12)) << "about its own center";
}

TEST(SpatialScenarioReader, ReadsPrismsAlongEveryAxis)
{
    const auto prism = [](const std::string &rest)
    {
        return onlyShape<Prism>(
            small("[{kind: prism, vertices: [[4, 5], [4, 8], [6, 5]], " + rest + "}]"));  // turned clockwise
    };
    const auto corner = [](const Prism &one, double height)
    {
        return Vector3d(one.pose * Vector3d(4, 8, height));
    };
    const Prism along = prism("axis: x, length: 3");
    EXPECT_EQ(along.vertices, (std::vector<Eigen::Vector2d>{{6, 5}, {4, 8}, {4, 5}})) << "counter-clockwise";
    EXPECT_EQ(along.halfLength, 1.5);
    EXPECT_EQ(along.axis(), Vector3d(1, 0, 0));
    EXPECT_EQ(corner(along, 1.5), Vector3d(1.5, 4, 8)) << "the section's coordinates are y and z";
    EXPECT_EQ(corner(prism("axis: y, length: 3"), 0.0), Vector3d(4, 0, 8));
    EXPECT_EQ(corner(prism("axis: z, length: 3"), 1.5), Vector3d(4, 8, 1.5));
    EXPECT_EQ(corner(prism("axis: [-2, 0, 0], length: 3"), 0.0), Vector3d(0, 4, 8));
    EXPECT_EQ(corner(prism("axis: x, center: [1, 2, 3], length: inf"), 0.0), Vector3d(1, 6, 11));
    EXPECT_EQ(prism("axis: x, length: inf").halfLength, std::numeric_limits<double>::infinity());
    const Prism slanted = prism("axis: [0, 3, 4], length: inf");
    EXPECT_TRUE(corner(slanted, 0.0).isApprox(Vector3d(4.0, -6.4, 4.8), 1e-12)) << "level x, upright y";
    for (const Prism &one : {along, slanted, prism("axis: y, length: 3"), prism("axis: [1, -1, 1], length: 3")})
        EXPECT_NEAR(one.pose.linear().determinant(), 1.0, 1e-12) << "a rotation, not a mirror image";
}

TEST(SpatialScenarioReader, CornersOnStraightSidesOfAPrismDoNoHarm)
{
    EXPECT_EQ(onlyShape<Prism>(small("[{kind: prism, axis: x, vertices: [[4, 5], [6, 5], [6, 6], [6, 7], [4, 7]], "
                                     "length: inf}]"))
                  .vertices.size(),
              5u);
}

TEST(SpatialScenarioReader, ReadsATipPath)
{
    const Scenario scenario = small("[]", "links: [{length: 1}, {length: 1}]", "{joints: [[0, 0], [0, 0]]}",
                                    "{tip_path: [[2, 0, 0], [1, 0, 1], [1, 0, 1]], tolerance: 1e-3}");
    const auto &goal = std::get<SpatialTipPath>(scenario.spatial().task.goal);
    EXPECT_EQ(goal.link, 1);
    EXPECT_EQ(goal.tolerance, 1e-3);
    EXPECT_EQ(goal.points, (std::vector<Vector3d>{{2, 0, 0}, {1, 0, 1}, {1, 0, 1}}));
    const Scenario first = small("[]", "links: [{length: 1}, {length: 1}]", "{joints: [[0, 0], [0, 0]]}",
                                 "{tip_path: [[1, 0, 0]], tolerance: 1e-3, link: 1}");
    EXPECT_EQ(std::get<SpatialTipPath>(first.spatial().task.goal).link, 0);
}

/// The whole of the VDSM paper's task: start straight, and all places of the tip free for it.
TEST(SpatialScenarioReader, TheSquareOfVdsmIsReadWithoutFaults)
{
    for (const auto &[name, count] :
         {std::pair{"none", 14}, std::pair{"obs1", 87}, std::pair{"obs2", 60}, std::pair{"obs3", 14}})
    {
        const Scenario scenario = readScenario(folder + "vdsm_" + name + ".yaml");
        const SpatialArm &arm = scenario.spatial().model->arm;
        const auto &goal = std::get<SpatialTipPath>(scenario.spatial().task.goal);
        EXPECT_EQ(arm.dimension(), 17);
        EXPECT_EQ(tipOf(arm, scenario.spatial().task.start), Vector3d(3126, 0, 0)) << name;
        EXPECT_EQ(goal.points.front(), Vector3d(3126, 0, 0)) << name;
        EXPECT_EQ(goal.points.back(), Vector3d(3126, 0, 0)) << name;
        EXPECT_EQ(static_cast<int>(goal.points.size()), count) << name;
        for (const Vector3d &corner :
             {Vector3d(3126, 1000, 1300), Vector3d(3126, -500, 1300), Vector3d(3126, -500, -200)})
            EXPECT_EQ(std::count(goal.points.begin(), goal.points.end(), corner), 1) << name;
        double nearest = 3126.0;
        for (const Vector3d &point : goal.points)
            nearest = std::min(nearest, point.x());
        EXPECT_NEAR(nearest, 3026.0, 0.1) << name << ": drawn back by 100";
    }
    for (const char *leg : {"corner", "edge"})
        EXPECT_EQ(
            std::get<SpatialTipGoal>(readScenario(folder + "vdsm_leg_" + leg + ".yaml").spatial().task.goal).point.x(),
            3126.0);
}

TEST(SpatialScenarioReader, AClosedMeshIsASolidWhoseNormalsPointOutwards)
{
    const auto cube =
        onlyShape<Mesh>(small("[{kind: mesh, file: cube.obj, scale: 2, position: [4, 0, 0], rotation: "
                              "{axis: z, angle: 90 deg}}]"));
    EXPECT_TRUE(cube.closed);
    ASSERT_EQ(cube.vertices.size(), 8u);
    EXPECT_EQ(cube.triangles.size(), 12u) << "squares are divided";
    EXPECT_NEAR(volume(cube), 8.0, 1e-9) << "one face of the file has its normal inwards";
    for (const Vector3d &vertex : cube.vertices)
        EXPECT_GE((vertex - Vector3d(2, 0, 0)).minCoeff(), -1e-12);
}

TEST(SpatialScenarioReader, OtherMeshesAreSurfaces)
{
    EXPECT_FALSE(onlyShape<Mesh>(small("[{kind: mesh, file: open.obj, position: [3, 0, 0]}]")).closed);
    const std::string surface = "[{kind: mesh, file: cube.obj, position: [-5, -5, -5], scale: 10, solid: ";
    EXPECT_NO_THROW(small(surface + "false}]")) << "the arm is within a hollow cube";
    EXPECT_THROW(small(surface + "true}]"), InputError);
}

TEST(SpatialScenarioReader, AllFormatsOfMeshesGiveTheSameSolid)
{
    const auto solid = [](const std::string &file)
    {
        return onlyShape<Mesh>(small("[{kind: mesh, file: " + file + ", position: [3, 0, 0]}]"));
    };
    for (const char *file : {"tetrahedron.obj", "tetrahedron.off", "tetrahedron.stl", "tetrahedron_binary.STL"})
    {
        const Mesh mesh = solid(file);
        EXPECT_EQ(mesh.vertices.size(), 4u) << file << ": points of STL's triangles are made one";
        EXPECT_EQ(mesh.triangles.size(), 4u) << file;
        EXPECT_TRUE(mesh.closed) << file;
        EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-12) << file;
    }
}

TEST(SpatialScenarioReader, TheTextOfAScenarioKeepsItsMeshes)
{
    const Scenario scenario = readScenario(folder + "spatial_mesh.yaml");
    EXPECT_THAT(scenario.text, testing::HasSubstr("\nfiles:\n"));
    const Scenario again = parseScenario(scenario.text, "a database, where there is no such file");
    EXPECT_EQ(again.text, scenario.text);
    const auto mesh = onlyShape<Mesh>(scenario);
    const auto kept = onlyShape<Mesh>(again);
    EXPECT_EQ(kept.triangles, mesh.triangles);
    EXPECT_EQ(kept.vertices, mesh.vertices) << "to the last bit";
    EXPECT_EQ(kept.closed, mesh.closed);
}

TEST(SpatialScenarioReader, SelfCollisionIsOptional)
{
    const std::string folded = "joints: dh, radius: 0.1, links: [{a: 1}, {a: 1}, {a: 1}]";
    const std::string start = "{joints: [0, 130 deg, 130 deg]}";
    EXPECT_FALSE(small("[]", folded, start).spatial().model->selfCollision);
    EXPECT_THROW(small("[]", folded + ", self_collision: true", start), InputError);
}

TEST(SpatialScenarioReader, MethodsKnowTheNumberOfJoints)
{
    const std::string file =
        "format: narrows/scenario/1\nname: small\nrobot: {kind: spatial_arm, links: [{length: 1}]}\nobstacles: []\n"
        "start: {joints: [[0, 0]]}\ngoal: {joints: [[0, 1]]}\nmethods: {hppm: {direction: ";
    EXPECT_EQ(parseScenario(file + "[1, 2]}}\n", "text").methods.at("hppm").at("direction"), "1, 2");
    EXPECT_THROW(parseScenario(file + "[1, 2, 3]}}\n", "text"), InputError);
}
}  // namespace
}  // namespace narrows
