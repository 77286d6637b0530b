// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LadderSearch.h"

#include <gtest/gtest.h>

#include "LadderScenes.h"
#include "kernel/chain/LadderArcs.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

LadderSearch search(const std::string &shape, double length, int links, double spacing = 8.0)
{
    const ChainScene<2> scene = ladderScene(shape);
    const AxisBox<2> bounds = boundsOf(scene.walls);
    LadderSearchOptions options;
    options.links = links;
    options.spacing = spacing;
    options.finestAngle = 0.02;
    return excludeLadder(
        {scene.entrance, {0.0, 1.0}, scene.goal, scene.tolerance, length, scene.radius, bounds.lower, bounds.upper},
        signedDistance<2>(scene.walls), options);
}

TEST(LadderArcs, DropNoDirectionThatIsFreeSomewhereInTheSquare)
{
    const ChainScene<2> scene = ladderScene("U40");
    const std::vector<PlanarObstacle> obstacles = obstaclesOf(scene.walls);
    const auto distance = signedDistance<2>(scene.walls);
    RandomNumbers random(5);
    const double length = 300.0, radius = 5.0, square = 10.0;
    LadderArcs finder(distance, length, radius, square, 0.02);
    int free = 0, blocked = 0;
    for (int trial = 0; trial < 60; ++trial)
    {
        const Vector2d center(random.uniform(0.0, 440.0), random.uniform(600.0, 1100.0));
        const std::vector<LadderArc> arcs = finder.around(center);
        for (int sample = 0; sample < 200; ++sample)
        {
            const Vector2d joint = center + Vector2d(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
            const double angle = random.uniform(-M_PI, M_PI);
            double least = distance(joint);
            for (int i = 1; i <= 3000; ++i)
                least = std::min(least, distance(joint + i * 0.1 * Vector2d(std::cos(angle), std::sin(angle))));
            const bool isKept =
                std::any_of(arcs.begin(), arcs.end(), [angle](const LadderArc &arc) { return arc.contains(angle); });
            if (least > radius + 0.1)
            {
                ++free;
                EXPECT_TRUE(isKept) << joint.transpose() << " " << angle;
            }
            else if (least < radius - square - 0.02 * length)
            {
                ++blocked;
                EXPECT_FALSE(isKept) << joint.transpose() << " " << angle;
            }
        }
    }
    EXPECT_GT(free, 500);
    EXPECT_GT(blocked, 500);
}

TEST(LadderArcs, MeetAcrossFullTurns)
{
    const LadderArc over{-0.5, 0.25}, under{6.0, 6.1};
    EXPECT_TRUE(over.meets(under));
    EXPECT_TRUE(under.meets(over));
    EXPECT_TRUE(over.contains(2.0 * M_PI));
    EXPECT_FALSE(over.contains(M_PI));
    EXPECT_FALSE((LadderArc{1.0, 2.0}).meets({2.1, 3.0}));
    EXPECT_TRUE((LadderArc{1.0, 2.0}).meets({2.0, 3.0}));
}

TEST(LadderSearch, ExcludesWhatDoesNotPassARightAngleBend)
{
    // The longest is 541.5; cells of 8 leave some 25 undecided.
    EXPECT_EQ(search("L", 540.0, 1).verdict, LadderVerdict::Open);
    EXPECT_EQ(search("L", 540.0, 2).verdict, LadderVerdict::Open);
    EXPECT_EQ(search("L", 570.0, 1).verdict, LadderVerdict::Excluded);
    EXPECT_EQ(search("L", 570.0, 2).verdict, LadderVerdict::Excluded);
    EXPECT_EQ(search("U40", 429.0, 2).verdict, LadderVerdict::Open);
    EXPECT_EQ(search("U40", 450.0, 2).verdict, LadderVerdict::Excluded);
}

TEST(LadderSearch, TwoLinksOnOnePathExcludeMoreThanOne)
{
    // In the short S-bend a single ladder of 550 passes; but where its front has to go in the middle, its rear cannot.
    EXPECT_EQ(search("Z300", 550.0, 1).verdict, LadderVerdict::Open);
    EXPECT_EQ(search("Z300", 550.0, 2).verdict, LadderVerdict::Excluded);
    EXPECT_EQ(search("Z300", 500.0, 2).verdict, LadderVerdict::Open) << "a path is known";
}

TEST(LadderSearch, FinerCellsExcludeMore)
{
    EXPECT_EQ(search("L", 565.0, 1, 20.0).verdict, LadderVerdict::Open);
    EXPECT_EQ(search("L", 565.0, 1, 5.0).verdict, LadderVerdict::Excluded);
}

TEST(LadderSearch, CountsAreTheSameTwice)
{
    const LadderSearch one = search("Z300", 510.0, 2), other = search("Z300", 510.0, 2);
    EXPECT_EQ(one.verdict, other.verdict);
    EXPECT_EQ(one.cells, other.cells);
    EXPECT_EQ(one.nodes, other.nodes);
    EXPECT_EQ(one.rays, other.rays);
    EXPECT_GT(one.nodes, 0);
}

TEST(LadderSearch, NamesWhatItCannotDo)
{
    const auto wall = [](const Vector2d &point)
    {
        return std::abs(point.y()) - 1.0;
    };
    LadderTask task{{0.0, 5.0}, {0.0, 1.0}, {0.0, 9.0}, 0.1, 3.0, 0.0, {-10.0, -10.0}, {10.0, 10.0}};
    LadderSearchOptions options;
    options.spacing = 0.25;
    options.links = 1;
    EXPECT_EQ(excludeLadder(task, wall, options).verdict, LadderVerdict::Open);
    task.goal.y() = -5.0;
    EXPECT_EQ(excludeLadder(task, wall, options).verdict, LadderVerdict::Excluded) << "the wall is in between";
    task.entrance.y() = 2.0;
    EXPECT_EQ(excludeLadder(task, wall, options).verdict, LadderVerdict::StartBlocked) << "the link behind is in it";
    task.entrance = {0.0, 50.0};
    EXPECT_EQ(excludeLadder(task, wall, options).verdict, LadderVerdict::StartBlocked) << "outside of the bounds";
    task.entrance = {0.0, 5.0};
    options.maxNodes = 10;
    EXPECT_EQ(excludeLadder(task, wall, options).verdict, LadderVerdict::TooManyNodes);
    EXPECT_EQ(toText(LadderVerdict::TooManyNodes), "too_many_nodes");
    options.links = 3;
    EXPECT_THROW(excludeLadder(task, wall, options), std::invalid_argument);
    options.links = 1;
    task.length = 0.0;
    EXPECT_THROW(excludeLadder(task, wall, options), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
