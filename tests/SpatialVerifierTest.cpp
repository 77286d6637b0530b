// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "SpatialOracle.h"
#include "VerdictChecks.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Judges a path whose ends are what was asked for.
Verdict judge(const SpatialModel &model, const Rows &path, double tolerance = 1e-6)
{
    VerifierOptions options;
    options.clearanceTolerance = tolerance;
    return verify(model, {path.front(), path.back()}, path, options);
}

SpatialJoint turning(int parent, const Vector3d &at, const Vector3d &axis)
{
    return {SpatialJoint::Kind::Revolute, parent, Isometry3d(Eigen::Translation3d(at)), axis, std::nullopt};
}

/// One link of length 1 along x at zero, that turns about the z axis.
SpatialModel pointer(std::vector<SpatialObstacle> obstacles, double radius = 0.0)
{
    return {SpatialArm({turning(-1, Vector3d::Zero(), Vector3d::UnitZ())},
                       {{0, Vector3d::Zero(), Vector3d::UnitX(), radius}}),
            std::move(obstacles)};
}

/// A link of length 1 along x that slides that way: a bolt.
SpatialModel bolt(std::vector<SpatialObstacle> obstacles, double radius)
{
    return {SpatialArm(
                {{SpatialJoint::Kind::Prismatic, -1, Isometry3d::Identity(), Vector3d::UnitX(), Interval{-3.0, 3.0}}},
                {{0, Vector3d::Zero(), Vector3d::UnitX(), radius}}),
            std::move(obstacles)};
}

SpatialObstacle box(const std::string &name, const Vector3d &low, const Vector3d &high)
{
    return {name, Box{Isometry3d(Eigen::Translation3d(0.5 * (low + high))), 0.5 * (high - low)}};
}

SpatialObstacle asMesh(const SpatialObstacle &obstacle)
{
    return {obstacle.name, surfaceOf(std::get<Box>(obstacle.shape))};
}

/// The same box as a prism along x, which may go on forever.
SpatialObstacle asPrism(const SpatialObstacle &obstacle, bool endless = false)
{
    const Box &box = std::get<Box>(obstacle.shape);
    const double y = box.halfExtents.y(), z = box.halfExtents.z();
    Isometry3d pose = box.pose;
    pose.linear() << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
    return {obstacle.name, Prism{{{-y, -z}, {y, -z}, {y, z}, {-y, z}}, pose, endless ? infinity : box.halfExtents.x()}};
}

TEST(SpatialVerifier, MeasuresASwingPastEveryShape)
{
    const Rows swing = rows({{-1.0}, {1.0}});
    const double above = std::hypot(std::hypot(2, 0.5) - 1.0, 0.75);
    expectClearance(judge(pointer({{"S", Sphere{{2, 0.5, 0.75}, 0.25}}}), swing), above - 0.25);
    expectClearance(judge(pointer({{"S", Sphere{{2, 0.5, 0.75}, 0.25}}}, 0.125), swing), above - 0.375);
    expectClearance(judge(pointer({{"C", Capsule{{2, 0, -5}, {2, 0, 5}, 0.25}}}), swing), 0.75);
    expectClearance(judge(pointer({{"Y", Cylinder{{2, 0, 0}, {0, 0, 1}, 0.25, 3.0}}}), swing), 0.75);
    expectClearance(judge(pointer({{"Y", Cylinder{{2, 0, 9}, {0, 0, 1}, 0.25, infinity}}}), swing), 0.75);
    expectClearance(judge(pointer({{"Y", Cylinder{{0.5, 0, 2}, {0, 0, 1}, 0.25, 0.5}}}), swing), 1.5);
    expectClearance(judge(pointer({{"Y", Cylinder{{9, 0, 1}, {1, 0, 0}, 0.25, infinity}}}), swing), 0.75);
    for (const SpatialObstacle &obstacle :
         {box("B", {1.25, -1, -1}, {2, 1, 1}), box("B", {0.25, 0.1, 0.25}, {1, 1, 1})})
    {
        expectClearance(judge(pointer({obstacle}), swing), 0.25);
        expectClearance(judge(pointer({asPrism(obstacle)}), swing), 0.25);
        expectClearance(judge(pointer({asMesh(obstacle)}), swing), 0.25);
        expectClearance(judge(pointer({asMesh(obstacle)}, 0.125), swing), 0.125);
    }
    const Isometry3d upright = Isometry3d::Identity();
    const std::vector<Eigen::Vector2d> wedge{{1.25, 0}, {2, -1}, {2, 1}};
    expectClearance(judge(pointer({{"P", Prism{wedge, upright, 3.0}}}), swing), 0.25);
    expectClearance(judge(pointer({{"P", Prism{wedge, upright, infinity}}}, 0.125), swing), 0.125);
    expectClearance(judge(pointer({asPrism(box("P", {7, -1, 0.75}, {9, 1, 2}), true)}), swing), 0.75);
    EXPECT_EQ(judge(pointer({}), swing).clearance, infinity);
}

TEST(SpatialVerifier, RefusesASwingIntoEveryShape)
{
    const Rows swing = rows({{-1.0}, {1.0}});
    const SpatialObstacle thin = box("hit", {0.5, -1e-4, -0.1}, {2, 1e-4, 0.1});
    for (const SpatialObstacle &obstacle :
         {SpatialObstacle{"hit", Sphere{{1.2, 0.5, 0.1}, 0.35}}, SpatialObstacle{"hit", Sphere{{0.5, 0, 0}, 1e-4}},
          SpatialObstacle{"hit", Capsule{{0.9, 0, -2}, {0.9, 0, 2}, 1e-3}},
          SpatialObstacle{"hit", Cylinder{{0.9, 0, 0.5}, {0, 0, 1}, 1e-3, 0.5001}},
          SpatialObstacle{"hit", Cylinder{{0.9, 0, 7}, {0, 0, 1}, 1e-3, infinity}}, thin, asMesh(thin), asPrism(thin),
          SpatialObstacle{"hit", Prism{{{0.9, -1e-4}, {1.1, -1e-4}, {0.9, 1e-4}}, Isometry3d::Identity(), infinity}}})
    {
        const Verdict verdict = judge(pointer({{"far", Sphere{{5, 5, 5}, 1}}, obstacle}), swing);
        expectRefusal(verdict, "collision", 0);
        EXPECT_EQ(verdict.link, 0);
        EXPECT_EQ(verdict.otherLink, -1);
        EXPECT_EQ(verdict.obstacle, "hit");
        EXPECT_GT(verdict.fraction, 0.0);
        EXPECT_LT(verdict.fraction, 1.0);
    }
    expectRefusal(judge(pointer({box("B", {1.05, -1, -1}, {2, 1, 1})}, 0.06), swing), "collision", 0);
}

TEST(SpatialVerifier, TellsFreeFromTouchingInANarrowSlot)
{
    const Rows through = rows({{-2.0}, {2.0}});
    for (const double clearance : {1e-3, 1e-5, 1e-7, 1e-9})
    {
        const double gap = 0.1 + clearance;
        const SpatialObstacle above = box("above", {-0.5, -1, gap}, {0.5, 1, 2});
        const SpatialObstacle below = box("below", {-0.5, -1, -2}, {0.5, 1, -gap});
        const SpatialObstacle beside{"beside", Cylinder{{0, gap + 1, 0}, {1, 0, 0}, 1.0, 0.5}};
        for (const SpatialModel &model :
             {bolt({above, below, beside}, 0.1), bolt({asMesh(above), asMesh(below)}, 0.1),
              bolt({asPrism(above), asPrism(below)}, 0.1), bolt({asPrism(above, true), asPrism(below, true)}, 0.1)})
        {
            expectClearance(judge(model, through, 1e-4), clearance, clearance);
            expectClearance(judge(model, through, 1e-11), clearance, 1e-11);
        }
        const SpatialObstacle tight = box("above", {-0.5, -1, 0.1 - clearance}, {0.5, 1, 2});
        expectRefusal(judge(bolt({tight}, 0.1), through), "collision", 0);
        expectRefusal(judge(bolt({asMesh(tight)}, 0.1), through), "collision", 0);
        expectRefusal(judge(bolt({asPrism(tight)}, 0.1), through), "collision", 0);
        expectRefusal(judge(bolt({asPrism(tight, true)}, 0.1), through), "collision", 0);
    }
}

TEST(SpatialVerifier, TellsFreeFromTouchingWhereALinkSwingsBy)
{
    const Rows swing = rows({{-1.0}, {1.5}});
    for (const double clearance : {1e-5, 1e-7, 1e-9})
        for (const int sign : {1, -1})
        {
            const double gap = sign * clearance;
            const SpatialObstacle wall = box("wall", {1 + gap, -1, -1}, {2, 1, 1});
            for (const SpatialObstacle &obstacle :
                 {SpatialObstacle{"S", Sphere{{1.5 + gap, 0, 0}, 0.5}},
                  SpatialObstacle{"C", Capsule{{1.5 + gap, 0, 0}, {1.5 + gap, 0.1, 5}, 0.5}},
                  SpatialObstacle{"Y", Cylinder{{1.5 + gap, 0, 0}, {0, 0, 1}, 0.5, 2.0}},
                  SpatialObstacle{"end", Cylinder{{2 + gap, 0, 0.3}, {1, 0, 0}, 0.5, 1.0}}, wall, asMesh(wall),
                  asPrism(wall)})
            {
                SCOPED_TRACE(obstacle.name + " " + std::to_string(gap));
                const Verdict verdict = judge(pointer({obstacle}), swing);
                if (sign > 0)
                    expectClearance(verdict, clearance);
                else
                    expectRefusal(verdict, "collision", 0);
            }
        }
}

/// As for the planar arm; what glides along the link is a point, an edge that crosses it, or something round.
TEST(SpatialVerifier, NeedsFewLooksHoweverNarrowItIs)
{
    SpatialJoint slide{SpatialJoint::Kind::Prismatic, -1, Isometry3d::Identity(), Vector3d::UnitX(), Interval{-3, 3}};
    const SpatialArm arm(
        {slide, turning(0, Vector3d::Zero(), Vector3d::UnitZ()), turning(1, Vector3d::UnitX(), Vector3d::UnitZ())},
        {{1, Vector3d::Zero(), Vector3d::UnitX(), 0.0}, {2, {0, 0, -0.28}, {1, 0, 0.12}, 0.0}});
    const Rows glide = rows({{-0.175, pi - 1.0, 0.75 - pi / 2}, {0.175, pi + 1.0, -0.75 - pi / 2}});
    const Vector3d slanted = Vector3d(0.0, 0.3, 1.0).normalized();
    for (const double clearance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11})
    {
        const Vector3d edge(-1 - clearance, 0.7, 0), center(-1.3 - clearance, 0.7, 0);
        const Isometry3d turned = Eigen::Translation3d(edge - std::sqrt(0.5) * Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(pi / 4, Vector3d::UnitZ());
        const std::vector<Eigen::Vector2d> square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
        const Mesh triangle{{edge + Vector3d::UnitZ(), edge - Vector3d::UnitZ(), {-2, 0.7, 0}}, {{0, 1, 2}}, false};
        for (const SpatialObstacle &obstacle :
             {SpatialObstacle{"ball", Sphere{center, 0.3}},
              SpatialObstacle{"can", Cylinder{center, {0, 0, 1}, 0.3, 1.0}},
              SpatialObstacle{"rod", Capsule{center - slanted, center + slanted, 0.3}},
              SpatialObstacle{"endless", Cylinder{center, slanted, 0.3, infinity}},
              SpatialObstacle{"box", Box{turned, {0.5, 0.5, 0.5}}}, SpatialObstacle{"triangle", triangle},
              SpatialObstacle{"prism", Prism{square, turned, 0.5}},
              SpatialObstacle{"endless prism", Prism{square, turned, infinity}}})
        {
            const Verdict verdict = judge({arm, {obstacle}}, glide, 1e-4);
            SCOPED_TRACE(obstacle.name + " " + std::to_string(clearance));
            expectClearance(verdict, clearance, std::min(clearance, 1e-4));
            EXPECT_LE(verdict.placements, 250u);
        }
    }
}

/// A link in a closed mesh touches none of its triangles.
TEST(SpatialVerifier, KnowsTheInsideOfAClosedMesh)
{
    const Rows swing = rows({{0.0}, {1.0}});
    Mesh shell = surfaceOf(Box{Isometry3d::Identity(), {2, 2, 2}});
    expectRefusal(judge(pointer({{"shell", shell}}), swing), "collision", 0);
    shell.closed = false;
    expectClearance(judge(pointer({{"shell", shell}}), swing), 1.0);
    shell.triangles.pop_back();
    expectClearance(judge(pointer({{"shell", shell}}), swing), 1.0);
    shell.closed = true;
    EXPECT_THROW(judge(pointer({{"shell", shell}}), swing), std::invalid_argument);
}

/// A link that hangs in the air beside the arm counts like any other, as does one that is fixed to the world.
TEST(SpatialVerifier, ChecksLinksThatHangTogetherWithNothing)
{
    const SpatialJoint joint = turning(-1, Vector3d::Zero(), Vector3d::UnitZ());
    const SpatialLink near{0, {0, 0, 0}, {1, 0, 0}, 0.1}, remote{0, {5, 0, 0}, {6, 0, 0}, 0.1};
    const SpatialLink fixed{-1, {0, 0, 3}, {0, 0, 4}, 0.1};
    const SpatialModel model{SpatialArm({joint}, {near, remote, fixed}),
                             {{"shell", surfaceOf(Box{Isometry3d(Eigen::Translation3d(5, 0, 0)), {2, 2, 2}})}}};
    const Verdict verdict = judge(model, rows({{0.0}, {0.1}}));
    expectRefusal(verdict, "collision", 0);
    EXPECT_EQ(verdict.link, 1);
    const SpatialModel other{SpatialArm({joint}, {near, remote, fixed}), {{"S", Sphere{{0, 1, 3.5}, 0.5}}}};
    expectClearance(judge(other, rows({{0.0}, {0.1}})), 0.4);
}

TEST(SpatialVerifier, FollowsAChainOfUniversalJoints)
{
    const SpatialArm arm = universalChain({1, 0, 0}, {1.0, 1.0}, 0.1, std::pair{Vector3d(0, 1, 0), Interval{-2, 2}});
    const Rows path = rows({{0.5, 0, 0, -pi / 2, 0}, {0.5, 0, 0, -pi / 2, pi / 2}});  // tip: up, then in y
    const Vector3d above(2, 0.5, 1.0), beside(2, 1.5, 0);
    for (const Vector3d &end : {above, beside})
        expectClearance(judge({arm, {{"S", Sphere{end + 0.8 * (end - Vector3d(2, 0.5, 0)), 0.5}}}}, path), 0.2);
    const SpatialTask task{path.front(), SpatialTipGoal{1, beside, 1e-6}};
    EXPECT_TRUE(verify({arm, {}}, task, path).accepted);
    expectRefusal(verify({arm, {}}, {path.front(), SpatialTipGoal{1, above, 1e-6}}, path), "goal", 1);
    EXPECT_THROW(verify({arm, {}}, {path.front(), SpatialTipGoal{2, above, 1e-6}}, path), std::invalid_argument);
}

TEST(SpatialVerifier, WantsTheTipsOfAPathInTheirOrder)
{
    const SpatialModel model = pointer({});
    const Rows path = rows({{0.0}, {0.5}, {1.0}, {0.5}});
    const auto at = [](double q)
    {
        return Vector3d(std::cos(q), std::sin(q), 0.0);
    };
    const auto judgeTips = [&](const std::vector<Vector3d> &tips, double tolerance = 1e-9)
    {
        return verify(model, {path.front(), SpatialTipPath{0, tips, tolerance}}, path);
    };
    EXPECT_TRUE(judgeTips({at(0.5)}).accepted);
    EXPECT_TRUE(judgeTips({at(0.0), at(0.5), at(1.0), at(0.5)}).accepted);
    EXPECT_TRUE(judgeTips({at(0.5), at(0.5), at(1.0), at(0.5), at(0.5)}).accepted) << "one waypoint, several tips";
    EXPECT_TRUE(judgeTips({at(1.0), at(0.501)}, 1.001e-3).accepted);
    const auto expectMissed = [](const Verdict &verdict, int tip)
    {
        expectRefusal(verdict, "tip_path", 3);
        EXPECT_EQ(verdict.tip, tip);
    };
    expectMissed(judgeTips({at(1.0), at(0.501)}, 0.999e-3), 1);
    expectMissed(judgeTips({at(0.25)}), 0);  // on the way, but at no waypoint
    expectMissed(judgeTips({at(1.0), at(0.5), at(1.0)}), 2);
    expectMissed(judgeTips({at(0.5), at(0.0), at(0.5)}), 1);
    expectRefusal(judgeTips({at(0.5), at(1.0)}), "goal", 3);
    EXPECT_EQ(judgeTips({at(0.5), at(1.0)}).tip, -1);
    const SpatialTask task{path.front(), SpatialTipPath{0, {at(1.0), at(0.5)}, 1e-9}};
    expectRefusal(verify(pointer({{"S", Sphere{at(0.25), 0.01}}}), task, path), "collision", 0);
    EXPECT_THROW(judgeTips({}), std::invalid_argument);
    EXPECT_THROW(verify(model, {path.front(), SpatialTipPath{1, {at(0.5)}, 1e-9}}, path), std::invalid_argument);
}

TEST(SpatialVerifier, ChecksLimits)
{
    const SpatialArm free = universalChain({0, 0, 0}, {1.0, 1.0}, 0.1);
    const SpatialArm bent = universalChain({0, 0, 0}, {1.0, 1.0}, 0.1, std::nullopt, 0.7);
    const Rows wide = rows({{0, 0, 0, 0}, {0, 0, 0.6, 0.6}, {0, 0, 0, 0}});
    EXPECT_TRUE(judge({free, {}}, wide).accepted);
    expectRefusal(judge({bent, {}}, wide), "limits", 1);
    const double half = std::acos(std::sqrt(std::cos(0.7)));
    EXPECT_TRUE(judge({bent, {}}, rows({{0, 0, 0, 0}, {0, 0, half, -half}})).accepted);
    expectRefusal(judge({bent, {}}, rows({{0, 0, 0, 0}, {0, 0, half, -half - 1e-8}})), "limits", 1);

    // The same without limits of the single joints: the set around 0 is meant, and full turns are counted.
    const SpatialArm shared(
        {turning(-1, Vector3d::Zero(), Vector3d::UnitY()), turning(0, Vector3d::Zero(), Vector3d::UnitZ())},
        {{1, Vector3d::Zero(), Vector3d::UnitX(), 0.1}}, {{0, 1, 0.7}});
    EXPECT_TRUE(judge({shared, {}}, rows({{0, 0}, {0.5, -0.4}})).accepted);
    expectRefusal(judge({shared, {}}, rows({{0, 0}, {pi, pi}})), "limits", 1);
    const Rows turned = rows({{2 * pi, 0}, {2 * pi, 0}});
    expectRefusal(verify({shared, {}}, {rows({{0, 0}})[0], turned[1]}, turned), "start", 0);
    expectRefusal(judge({shared, {}}, turned), "limits", 0);
}

TEST(SpatialVerifier, ChecksStartAndGoal)
{
    const SpatialModel model = pointer({});
    const Rows ends = rows({{0.0}, {1.0}});
    const SpatialTask task{ends[0], ends[1]};
    EXPECT_TRUE(verify(model, task, rows({{2 * pi}, {1.0 - 2 * pi}})).accepted);
    expectRefusal(verify(model, task, rows({{1e-8}, {1.0}})), "start", 0);
    expectRefusal(verify(model, task, rows({{0.0}, {0.5}, {1.0 + 1e-8}})), "goal", 2);
    expectRefusal(verify(model, task, {}), "empty_path", -1);
    expectRefusal(verify(model, task, rows({{0.0}, {0.5, 0.5}, {1.0}})), "dimension", 1);
    expectRefusal(verify(model, task, rows({{0.0}, {std::nan("")}, {1.0}})), "not_finite", 1);
    const Rows slide = rows({{0.0}, {3.1}, {0.0}});
    expectRefusal(judge(bolt({}, 0.1), slide), "limits", 1);
    EXPECT_THROW(verify(model, {rows({{0.0, 1.0}})[0], ends[1]}, ends), std::invalid_argument);
    EXPECT_THROW(judge(model, ends, 0.0), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
