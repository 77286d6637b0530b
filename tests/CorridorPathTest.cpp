// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/CorridorPath.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "TightScenes.h"
#include "kernel/fields/CorridorClasses.h"
#include "kernel/fields/DistanceField.h"
#include "kernel/fields/HomotopyWords.h"
#include "kernel/fields/PathWindow.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Least costs from a cell by relaxing all steps between neighbours until nothing changes.
std::vector<double> relaxedCosts(const VoxelGrid<2> &grid, const std::vector<float> &clearance,
                                 const CorridorOptions &options, int start)
{
    const CorridorCost cost(grid, clearance, options);
    std::vector<double> costs(grid.cells(), std::numeric_limits<double>::infinity());
    costs[start] = 0.0;
    for (bool changed = true; changed;)
    {
        changed = false;
        for (int cell = 0; cell < grid.cells(); ++cell)
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                {
                    const Eigen::Vector2i from = grid.index(cell), to = from + Eigen::Vector2i(dx, dy);
                    const bool allowed = grid.free(from) && grid.free(to) && grid.free({from.x(), to.y()}) &&
                                         grid.free({to.x(), from.y()}) &&
                                         (options.steps == CellSteps::All || dx * dy == 0);
                    if (!allowed)
                        continue;
                    const double there =
                        costs[cell] + 0.5 * grid.spacing() * std::hypot(dx, dy) * (cost(cell) + cost(grid.cell(to)));
                    changed = changed || there < costs[grid.cell(to)] * (1.0 - 1e-12);
                    costs[grid.cell(to)] = std::min(costs[grid.cell(to)], there);
                }
    }
    return costs;
}

TEST(CorridorPath, IsTheCheapestOneOnRandomGrids)
{
    int connected = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
    {
        std::mt19937 generator(seed);
        auto grid = VoxelGrid<2>::make({0, 0}, {12.5, 9.0}, 0.5).grid;
        for (int cell = 1; cell + 1 < grid.cells(); ++cell)
            if (std::bernoulli_distribution(0.3)(generator))
                grid.occupy(cell);
        const auto clearance = distanceField(grid, GridBorder::Wall);
        CorridorOptions options;
        options.preference = 0.5 * (seed % 7);
        options.steps = seed % 2 == 0 ? CellSteps::All : CellSteps::Faces;
        const auto corridor = findCorridor<2>(grid, clearance, grid.center(0), grid.center(grid.cells() - 1), options);
        const double least = relaxedCosts(grid, clearance, options, 0).back();
        EXPECT_EQ(corridor.failure == CorridorFailure::None, std::isfinite(least)) << "seed " << seed;
        if (!std::isfinite(least))
            continue;
        ++connected;
        EXPECT_NEAR(corridor.cost, least, 1e-6 * least) << "seed " << seed;
        EXPECT_EQ(corridor.cells.front(), 0);
        EXPECT_EQ(corridor.cells.back(), grid.cells() - 1);
    }
    EXPECT_GT(connected, 10);
}

TEST(CorridorPath, KeepsToTheMiddleOfAChannel)
{
    // Eleven rows in a wall: the middle one has a clearance of 6, and 28 steps of the cheapest cost there are.
    const auto grid = VoxelGrid<2>::make({0, 0}, {40, 11}, 1.0).grid;
    const auto clearance = distanceField(grid, GridBorder::Wall);
    const auto corridor = findCorridor<2>(grid, clearance, {6.5, 5.5}, {33.5, 5.5});
    EXPECT_DOUBLE_EQ(corridor.cost, 27.0);
    EXPECT_EQ(corridor.clearance, 6.0);
    for (const Vector2d &point : corridor.path)
        EXPECT_EQ(point.y(), 5.5);
    CorridorOptions shortest;
    shortest.preference = 0.0;
    EXPECT_DOUBLE_EQ(findCorridor<2>(grid, clearance, {0.2, 0.7}, {39.9, 10.9}, shortest).cost,
                     29.0 + 10.0 * std::sqrt(2.0));
}

TEST(CorridorPath, StaysInTheMiddleOfTheLegsOfTheUTurn)
{
    const auto grid = uTurn(10.0);
    const auto clearance = distanceField(grid, GridBorder::Wall);
    const auto corridor = findCorridor<2>(grid, clearance, {100, 50}, {340, 50});
    ASSERT_EQ(corridor.failure, CorridorFailure::None);
    for (const Vector2d &point : corridor.path)
    {
        const bool inLeg = point.y() > 150.0 && point.y() < 700.0;
        EXPECT_TRUE(!inLeg || std::abs(std::abs(point.x() - 220.0) - 120.0) <= 5.0 + 1e-9) << point.transpose();
    }
    EXPECT_EQ(corridor.path.front(), Vector2d(100, 50));
    EXPECT_EQ(corridor.path.back(), Vector2d(340, 50));
}

TEST(CorridorPath, CutsNoCorners)
{
    auto grid = VoxelGrid<3>::make({0, 0, 0}, {2, 2, 2}, 1.0).grid;
    for (int cell : {1, 2, 4})  // all that the first cell has a side in common with
        grid.occupy(cell);
    const auto clearance = distanceField(grid, GridBorder::Open);
    EXPECT_EQ(findCorridor<3>(grid, clearance, grid.center(0), grid.center(7)).failure, CorridorFailure::NotConnected);
}

TEST(CorridorPath, SaysWhyThereIsNone)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {9, 5}, 1.0).grid;
    for (int y = 0; y < 5; ++y)
        grid.occupy(grid.cell({4, y}));
    const auto clearance = distanceField(grid, GridBorder::Open);
    const Vector2d left(1.5, 2.5), wall(4.5, 2.5), right(7.5, 2.5), outside(-0.5, 1.0);
    const auto why = [&](const Vector2d &start, const Vector2d &goal)
    {
        return toText(findCorridor<2>(grid, clearance, start, goal).failure);
    };
    EXPECT_EQ(why(outside, right), "start_outside");
    EXPECT_EQ(why(left, outside), "goal_outside");
    EXPECT_EQ(why(wall, right), "start_blocked");
    EXPECT_EQ(why(left, wall), "goal_blocked");
    EXPECT_EQ(why(left, right), "not_connected");
    EXPECT_EQ(why(left, left), "none");
    EXPECT_EQ(findCorridors<2>(grid, clearance, left, right).at(0).failure, CorridorFailure::NotConnected);
    EXPECT_THROW(findCorridor<2>(grid, {}, left, left), std::invalid_argument);
}

TEST(HomotopyWords, TellWhichSideOfAnIslandAPathGoes)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {9, 7}, 1.0).grid;
    grid.occupy(grid.cell({4, 3}));
    grid.occupy(grid.cell({5, 4}));  // touches it at a corner: one island
    grid.occupy(grid.cell({1, 0}));  // no island: it reaches the border
    const HomotopyWords words(grid);
    EXPECT_EQ(words.islands(), 1);
    const auto walk = [&grid](std::vector<Eigen::Vector2i> corners)
    {
        std::vector<int> cells{grid.cell(corners[0])};
        for (std::size_t i = 1; i < corners.size(); ++i)
            for (Eigen::Vector2i at = corners[i - 1]; at != corners[i];)
            {
                at += (corners[i] - at).cwiseSign();
                cells.push_back(grid.cell(at));
            }
        return cells;
    };
    EXPECT_EQ(words.word(walk({{0, 3}, {0, 1}, {8, 1}, {8, 3}})), std::vector<int>());
    EXPECT_EQ(words.word(walk({{0, 3}, {0, 6}, {8, 6}, {8, 3}})), std::vector<int>({1}));
    EXPECT_EQ(words.word(walk({{0, 6}, {8, 6}, {8, 5}, {0, 5}, {0, 6}})), std::vector<int>());
    EXPECT_EQ(words.word(walk({{2, 1}, {2, 6}, {7, 6}, {7, 1}, {2, 1}, {2, 6}, {7, 6}, {7, 1}})),
              std::vector<int>({1, 1}));
    EXPECT_EQ(words.word(walk({{7, 1}, {7, 6}, {2, 6}, {2, 1}})), std::vector<int>({-1}));
}

TEST(HomotopyWords, KeepRaysOfOneColumnInOrder)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {7, 9}, 1.0).grid;
    grid.occupy(grid.cell({3, 2}));
    grid.occupy(grid.cell({3, 6}));
    const HomotopyWords words(grid);
    std::vector<int> overBoth, between;
    for (int x = 0; x < 7; ++x)
    {
        overBoth.push_back(grid.cell({x, 8}));
        between.push_back(grid.cell({x, 4}));
    }
    EXPECT_EQ(words.word(between), std::vector<int>({1}));
    EXPECT_EQ(words.word(overBoth), std::vector<int>({1, 2}));
    std::vector<int> toAndFro = overBoth;
    toAndFro.insert(toAndFro.end(), overBoth.rbegin() + 1, overBoth.rend());
    EXPECT_TRUE(words.word(toAndFro).empty());
}

TEST(CorridorClasses, FindsEveryWayAroundThreeBlocks)
{
    // Three blocks in a row leave four gaps between and beside them.
    auto grid = VoxelGrid<2>::make({0, 0}, {30, 40}, 0.5).grid;
    for (double y : {3.0, 16.0, 27.0})
        grid.occupyWithin([y](const Vector2d &p)
                          { return std::max(std::abs(p.x() - 15.0) - 2.0, std::max(y - p.y(), p.y() - y - 8.0)); },
                          0.0);
    const auto clearance = distanceField(grid, GridBorder::Wall);
    CorridorClassOptions options;
    options.count = 4;
    const auto corridors = findCorridors<2>(grid, clearance, {4, 20}, {26, 20}, options);
    ASSERT_EQ(corridors.size(), 4U);
    const HomotopyWords words(grid);
    std::set<std::vector<int>> kinds;
    for (std::size_t i = 0; i < corridors.size(); ++i)
    {
        kinds.insert(words.word(corridors[i].cells));
        EXPECT_GE(corridors[i].cost, corridors[i > 0 ? i - 1 : 0].cost);
    }
    EXPECT_EQ(kinds, (std::set<std::vector<int>>{{}, {1}, {1, 2}, {1, 2, 3}}));
}

TEST(CorridorClasses, StoppedSearchesComeAgain)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {30, 40}, 0.2).grid;
    for (double y : {3.0, 16.0, 27.0})
        grid.occupyWithin([y](const Vector2d &p)
                          { return std::max(std::abs(p.x() - 15.0) - 2.0, std::max(y - p.y(), p.y() - y - 8.0)); },
                          0.0);
    const auto clearance = distanceField(grid, GridBorder::Wall);
    const CorridorOptions options;
    CorridorClasses<2> whole(grid, clearance, {4, 20}, {26, 20}, options, 4.0);
    CorridorClasses<2> interrupted(grid, clearance, {4, 20}, {26, 20}, options, 4.0);
    for (int kind = 0; kind < 4; ++kind)
    {
        int questions = 0;
        const auto expected = whole.next(12, [&questions] { return ++questions < 0; });
        ASSERT_TRUE(expected);
        ASSERT_GE(questions, 2) << "a search through tens of thousands of cells asks several times";
        for (int patience = 0; patience < 2; ++patience)
        {
            int asked = 0;
            const auto stopped = interrupted.next(1, [&] { return asked++ == patience; });
            ASSERT_TRUE(stopped);
            EXPECT_EQ(stopped->failure, CorridorFailure::Stopped);
        }
        const auto found = interrupted.next(12);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->cells, expected->cells);
        EXPECT_EQ(interrupted.searches(), whole.searches());
    }
}

TEST(CorridorClasses, FindsOnlyOneWayInTheUTurn)
{
    const auto grid = uTurn(20.0);
    const auto clearance = distanceField(grid, GridBorder::Wall);
    EXPECT_EQ(findCorridors<2>(grid, clearance, {100, 50}, {340, 50}).size(), 1U);
}

TEST(CorridorClasses, FindsBothDuctsInSpace)
{
    const auto grid = gridOfRooms<3>({0, 0, 0}, {100, 60, 60}, 2.5,
                                     {{{0, 0, 0}, {20, 60, 60}},
                                      {{80, 0, 0}, {100, 60, 60}},
                                      {{15, 5, 5}, {85, 20, 20}},
                                      {{15, 40, 35}, {85, 55, 50}}});
    const auto clearance = distanceField(grid, GridBorder::Wall);
    const auto corridors = findCorridors<3>(grid, clearance, {5, 30, 30}, {95, 30, 30});
    ASSERT_EQ(corridors.size(), 2U);
    const double first = corridors[0].path[corridors[0].path.size() / 2].y();
    const double second = corridors[1].path[corridors[1].path.size() / 2].y();
    EXPECT_NEAR(std::min(first, second), 12.5, 2.5);
    EXPECT_NEAR(std::max(first, second), 47.5, 2.5);
}

TEST(CorridorPath, GoesThroughThePipeAndTheClutter)
{
    const auto pipe = bentPipe(5.0);
    const auto line = bentPipeLine();
    const auto through = findCorridor<3>(pipe, distanceField(pipe, GridBorder::Wall), line.front(), line.back());
    ASSERT_EQ(through.failure, CorridorFailure::None);
    EXPECT_LT(lengthOf<3>(through.path), lengthOf<3>(line));
    EXPECT_GT(lengthOf<3>(through.path), 0.85 * lengthOf<3>(line));
    EXPECT_GE(through.clearance, 20.0 / std::sqrt(2.0));

    const auto boxes = clutterGrid(700, 5.0, 3.0);
    const Vector3d start(40, 240, 240), goal(760, 100, 380);
    const auto corridors = findCorridors<3>(boxes, distanceField(boxes, GridBorder::Wall), start, goal);
    ASSERT_EQ(corridors.size(), 3U);
    for (const auto &corridor : corridors)
        EXPECT_GE(lengthOf<3>(corridor.path), (goal - start).norm());
}

TEST(PathWindow, KeepsEndsAndStraightLinesAndRoundsCorners)
{
    const PointPath<2> corner{{0, 0}, {10, 0}, {10, 10}};
    const PointPath<2> points = resampled<2>(corner, 1.0);
    ASSERT_EQ(points.size(), 21U);
    EXPECT_TRUE(points[13].isApprox(Vector2d(10, 3)));
    const PointPath<2> smooth = windowed<2>(points, 2, 1);
    EXPECT_EQ(smooth.front(), corner.front());
    EXPECT_EQ(smooth.back(), corner.back());
    EXPECT_TRUE(smooth[5].isApprox(Vector2d(5, 0)));
    EXPECT_TRUE(smooth[10].isApprox(Vector2d(9.4, 0.6)));  // (8 + 9 + 10 + 10 + 10) / 5
}
}  // namespace
}  // namespace narrows
