// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Verifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "PaperScenes.h"
#include "VerdictChecks.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

PlanarTask between(const Rows &path)
{
    return {path.front(), path.back(), {}};
}

/// Judges a path whose ends are what was asked for.
Verdict judge(const PlanarModel &model, const Rows &path, double tolerance = 1e-6)
{
    VerifierOptions options;
    options.clearanceTolerance = tolerance;
    return verify(model, between(path), path, options);
}

/// One link of length 1 that turns about the origin.
PlanarModel pointer(std::vector<PlanarObstacle> obstacles, double radius = 0.0)
{
    return {PlanarArm({0, 0}, {{1.0, -1}}, radius), std::move(obstacles)};
}

/// A link that points along the x axis and slides that way: a bolt.
PlanarModel bolt(std::vector<PlanarObstacle> obstacles, double radius)
{
    return {PlanarArm({0, 0}, {{1.0, -1}}, radius, Slide{{1, 0}, -3.0, 3.0}), std::move(obstacles)};
}

PlanarObstacle box(const std::string &name, const Vector2d &low, const Vector2d &high)
{
    return {name, Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}}};
}

Polygon notched()
{
    return {{{1, -1}, {2, -1}, {2, 1}, {1, 1}, {1, 0.2}, {1.5, 0.2}, {1.5, -0.2}, {1, -0.2}}};
}

TEST(Verifier, MeasuresASwingPastEveryShape)
{
    const Rows swing = rows({{-1.0}, {1.0}});
    expectClearance(judge(pointer({{"C", Circle{{2, 0.5}, 0.25}}}), swing), std::hypot(2, 0.5) - 1.25);
    expectClearance(judge(pointer({{"E", Superellipse{{2.5, 0}, {1, 3}, 4.0}}}), swing), 0.5);
    expectClearance(judge(pointer({{"E", Superellipse{{2.5, 0}, {1, 0.5}, 2.0}}}), swing), 0.5);
    expectClearance(judge(pointer({box("B", {1.25, -1}, {2, 1})}), swing), 0.25);
    expectClearance(judge(pointer({{"T", Polygon{{{1.5, 0}, {3, -1}, {3, 1}}}}}), swing), 0.5);
    expectClearance(judge(pointer({{"C", Circle{{2, 0.5}, 0.25}}}, 0.125), swing), std::hypot(2, 0.5) - 1.375);
    EXPECT_EQ(judge(pointer({}), swing).clearance, infinity);
}

TEST(Verifier, RefusesASwingIntoEveryShape)
{
    const Rows swing = rows({{-1.0}, {1.0}});
    for (const PlanarObstacle &obstacle :
         {PlanarObstacle{"hit", Circle{{1.5, 0.5}, 0.625}},
          PlanarObstacle{"hit", Superellipse{{1.5, 0}, {0.55, 0.1}, 4.0}}, box("hit", {0.875, -0.1}, {2, 0.1}),
          PlanarObstacle{"hit", Polygon{{{0.99, 0}, {3, -1}, {3, 1}}}}, PlanarObstacle{"hit", Circle{{0.5, 0}, 1e-4}}})
    {
        const Verdict verdict = judge(pointer({{"far", Circle{{5, 5}, 1}}, obstacle}), swing);
        expectRefusal(verdict, "collision", 0);
        EXPECT_EQ(verdict.link, 0);
        EXPECT_EQ(verdict.obstacle, "hit");
        EXPECT_GT(verdict.fraction, 0.0);
        EXPECT_LT(verdict.fraction, 1.0);
    }
    expectRefusal(judge(pointer({box("B", {1.05, -1}, {2, 1})}, 0.06), swing), "collision", 0);
}

/// Both ends and nearly all of the way are free; no sampling at a usual resolution sees the wall.
TEST(Verifier, SeesAThinWall)
{
    const double thickness = 1e-4;
    const Vector2d along(std::sqrt(0.5), std::sqrt(0.5)), across = thickness * Vector2d(-along.y(), along.x());
    const PlanarObstacle wall{"wall", Polygon{{0.5 * along, 2 * along, 2 * along + across, 0.5 * along + across}}};
    const Verdict verdict = judge(pointer({wall}), rows({{-1.0}, {0.0}, {pi / 2}, {3.0}}));
    expectRefusal(verdict, "collision", 1);
    EXPECT_NEAR(verdict.fraction, 0.5, 2e-4);
    EXPECT_EQ(verdict.obstacle, "wall");
    // The other way round is free: rows stand as they are, and are not wrapped.
    expectClearance(judge(pointer({wall}), rows({{2 * pi}, {pi / 2}})), (0.5 * along + across).x());
    expectRefusal(judge(pointer({wall}), rows({{0.1}, {2 * pi}})), "collision", 0);
    expectRefusal(judge(pointer({wall}), rows({{0.1}, {20 * pi}})), "collision", 0);
}

TEST(Verifier, UnderstandsNotches)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.3, -1}}), {{"N", notched()}}};
    expectClearance(judge(model, rows({{0.0}})), 0.2);
    expectClearance(judge(model, rows({{-0.1}, {0.1}})), 0.2 - 1.3 * std::sin(0.1));
    expectRefusal(judge(model, rows({{-0.1}, {0.2}})), "collision", 0);
    const PlanarModel inside{PlanarArm({1.75, 0}, {{0.1, -1}}), {{"N", notched()}}};
    expectRefusal(judge(inside, rows({{0.0}, {3.0}})), "collision", 0);
    const PlanarModel inNotch{PlanarArm({1.25, 0}, {{0.1, -1}}), {{"N", notched()}}};
    expectClearance(judge(inNotch, rows({{0.0}, {2 * pi}})), 0.1);
}

TEST(Verifier, TellsFreeFromTouchingInANarrowSlot)
{
    const Rows through = rows({{-2.0, 0.0}, {2.0, 0.0}});
    for (const double clearance : {1e-3, 1e-5, 1e-7, 1e-9})
    {
        const double gap = 0.1 + clearance;
        const PlanarModel model =
            bolt({box("above", {-0.5, gap}, {0.5, 2}), box("below", {-0.5, -2}, {0.5, -gap})}, 0.1);
        expectClearance(judge(model, through, 1e-4), clearance, clearance);
        expectClearance(judge(model, through, 1e-11), clearance, 1e-11);
        const PlanarModel tight = bolt({box("above", {-0.5, 0.1 - clearance}, {0.5, 2})}, 0.1);
        expectRefusal(judge(tight, through), "collision", 0);
    }
    EXPECT_FALSE(judge(bolt({box("above", {-0.5, 0.1}, {0.5, 2})}, 0.1), through).accepted);
}

TEST(Verifier, TellsFreeFromTouchingWhereALinkSwingsBy)
{
    const Rows swing = rows({{-1.0}, {1.5}});
    for (const double clearance : {1e-5, 1e-7, 1e-9})
    {
        expectClearance(judge(pointer({{"C", Circle{{1.5 + clearance, 0}, 0.5}}}), swing), clearance);
        expectClearance(judge(pointer({{"E", Superellipse{{1.5 + clearance, 0}, {0.5, 2}, 4.0}}}), swing), clearance);
        expectClearance(judge(pointer({box("B", {1 + clearance, -1}, {2, 1})}), swing), clearance);
        for (const PlanarObstacle &obstacle : {PlanarObstacle{"C", Circle{{1.5 - clearance, 0}, 0.5}},
                                               PlanarObstacle{"E", Superellipse{{1.5 - clearance, 0}, {0.5, 2}, 4.0}},
                                               box("B", {1 - clearance, -1}, {2, 1})})
        {
            const Verdict verdict = judge(pointer({obstacle}), swing);
            expectRefusal(verdict, "collision", 0);
            EXPECT_NEAR(verdict.fraction, 0.4, 1e-2);
        }
    }
    const Verdict touching = judge(pointer({{"C", Circle{{1.5, 0}, 0.5}}}), swing);
    EXPECT_FALSE(touching.accepted);
    EXPECT_TRUE(touching.reason == "collision" || touching.reason == "not_certified") << touching.reason;
}

/// A link that turns while it glides past something at its middle: its carrier keeps away in a curve. Only a separating
/// line that turns, too, holds for more than a moment.
TEST(Verifier, NeedsFewLooksHoweverNarrowItIs)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}, {1.0, 0}}, 0.0, Slide{{1, 0}, -3.0, 3.0});
    const Rows glide = rows({{-0.175, pi - 1.0, pi / 2 - 0.25}, {0.175, pi + 1.0, pi / 2 + 0.25}});
    for (const double clearance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11})
        for (const PlanarObstacle &obstacle :
             {PlanarObstacle{"C", Circle{{-1.3 - clearance, 0.7}, 0.3}},
              PlanarObstacle{"T", Polygon{{{-1 - clearance, 0.7}, {-2, 1.2}, {-2, 0.2}}}}})
        {
            const Verdict verdict = judge({arm, {obstacle}}, glide, 1e-4);
            expectClearance(verdict, clearance, std::min(clearance, 1e-4));
            EXPECT_LE(verdict.placements, 250u) << obstacle.name << " " << clearance;
        }
}

/// To the digits that prototypes with other geometry code gave.
TEST(Verifier, ReproducesTheClearancesOfThePapersStates)
{
    const std::vector<std::pair<double, double>> startAndGoal{{0.9724, 0.0564}, {2.0610, 0.0155}, {0.2700, 0.1239}};
    for (int number = 1; number <= 3; ++number)
    {
        const PaperScene scene = paperScene(number);
        const auto &goal = std::get<Eigen::VectorXd>(scene.task.goal);
        EXPECT_NEAR(judge(scene.model, {scene.task.start}).clearance, startAndGoal[number - 1].first, 5.1e-5);
        EXPECT_NEAR(judge(scene.model, {goal}).clearance, startAndGoal[number - 1].second, 5.1e-5);
        expectRefusal(judge(scene.model, {scene.task.start, goal}), "collision", 0);
    }
}

TEST(Verifier, ChecksTheFormOfThePath)
{
    const PlanarModel model = pointer({});
    const PlanarTask task = between(rows({{0.0}, {1.0}}));
    expectRefusal(verify(model, task, {}), "empty_path", -1);
    expectRefusal(verify(model, task, rows({{0.0}, {0.5, 0.5}, {1.0}})), "dimension", 1);
    expectRefusal(verify(model, task, rows({{0.0}, {}, {1.0}})), "dimension", 1);
    expectRefusal(verify(model, task, rows({{0.0}, {0.5}, {std::nan("")}, {1.0}})), "not_finite", 2);
    expectRefusal(verify(model, task, rows({{-infinity}, {1.0}})), "not_finite", 0);
    EXPECT_TRUE(verify(model, task, rows({{0.0}, {0.5}, {1.0}})).accepted);
}

TEST(Verifier, ChecksStartAndGoal)
{
    const PlanarModel model = pointer({});
    const PlanarTask task = between(rows({{0.0}, {1.0}}));
    expectRefusal(verify(model, task, rows({{1e-8}, {1.0}})), "start", 0);
    expectRefusal(verify(model, task, rows({{0.0}, {0.5}, {1.0 + 1e-8}})), "goal", 2);
    expectRefusal(verify(model, task, rows({{0.0}})), "goal", 0);
    EXPECT_TRUE(verify(model, task, rows({{2 * pi}, {1.0 - 2 * pi}})).accepted);
    EXPECT_TRUE(verify(model, between(rows({{0.5}})), rows({{0.5}})).accepted);

    const PlanarModel sliding = bolt({}, 0.0);
    expectRefusal(verify(sliding, between(rows({{0.0, 0.0}})), rows({{2 * pi, 0.0}})), "start", 0);
}

TEST(Verifier, CountsTurnsOfJointsWithLimitsOnly)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}}), {}};
    PlanarTask task = between(rows({{0.0, 0.0}, {0.5, 1.0}}));
    task.limits.angles = {std::nullopt, Interval{-9.0, 9.0}};
    EXPECT_TRUE(verify(model, task, rows({{0.0, 0.0}, {0.5 + 2 * pi, 1.0}})).accepted);
    expectRefusal(verify(model, task, rows({{0.0, 0.0}, {0.5, 1.0 + 2 * pi}})), "goal", 1);
    // Counted against its parent, link 1 has not turned if both have.
    task.limits.convention = AngleConvention::Relative;
    EXPECT_TRUE(verify(model, task, rows({{0.0, 0.0}, {0.5 + 2 * pi, 1.0 + 2 * pi}})).accepted);
    expectRefusal(verify(model, task, rows({{0.0, 0.0}, {0.5 + 2 * pi, 1.0}})), "goal", 1);
}

TEST(Verifier, ReachesATipGoal)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}}), {}};
    const Rows path = rows({{0.0, 0.0}, {0.0, pi / 2}});
    EXPECT_TRUE(verify(model, {path.front(), TipGoal{1, {1.0, 1.0005}, 1e-3}, {}}, path).accepted);
    expectRefusal(verify(model, {path.front(), TipGoal{1, {1.0, 1.002}, 1e-3}, {}}, path), "goal", 1);
    EXPECT_TRUE(verify(model, {path.front(), TipGoal{0, {1.0, 0.0}, 1e-3}, {}}, path).accepted);
}

TEST(Verifier, ChecksLimitsInTheirConvention)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}}), {}};
    const Rows path = rows({{0.0, 0.0}, {1.0, 1.5}, {2.0, 1.0}});
    PlanarTask task = between(path);
    task.limits.angles = {std::nullopt, Interval{-1.0, 1.0}};
    expectRefusal(verify(model, task, path), "limits", 1);  // absolute: 1.5
    task.limits.convention = AngleConvention::Relative;
    EXPECT_TRUE(verify(model, task, path).accepted);  // relative: 0, 0.5, -1
    task.limits.angles[1]->lower = -0.9;
    expectRefusal(verify(model, task, path), "limits", 2);

    const Rows slide = rows({{0.0, 0.0}, {3.1, 0.0}, {0.0, 0.0}});
    expectRefusal(verify(bolt({}, 0.0), between(slide), slide), "limits", 1);
}

TEST(Verifier, BlamesItsCallerForNonsense)
{
    const PlanarModel model = pointer({});
    const Rows path = rows({{0.0}, {1.0}});
    EXPECT_THROW(verify(model, between(rows({{0.0, 1.0}})), path), std::invalid_argument);
    EXPECT_THROW(verify(model, {path[0], TipGoal{1, {1, 0}, 1e-3}, {}}, path), std::invalid_argument);
    EXPECT_THROW(verify(model, {path[0], path[1], {AngleConvention::Absolute, {{}, {}}}}, path), std::invalid_argument);
    EXPECT_THROW(judge(model, path, 0.0), std::invalid_argument);
    EXPECT_THROW(judge(model, path, std::nan("")), std::invalid_argument);
}

/// Such rows are finite, but sines of them are noise: nothing may be certified, and it has to end.
TEST(Verifier, RefusesAnglesBeyondReason)
{
    const PlanarModel model = pointer({{"C", Circle{{3, 0}, 0.5}}});
    expectRefusal(judge(model, rows({{0.0}, {1e300}})), "not_certified", 0);
    expectRefusal(judge(model, rows({{-1.7e308}, {1.7e308}})), "not_finite", 1);
}
}  // namespace
}  // namespace narrows
