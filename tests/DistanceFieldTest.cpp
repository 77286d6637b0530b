// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/DistanceField.h"

#include <random>

#include <gtest/gtest.h>

#include "TightScenes.h"

namespace narrows
{
namespace
{
/// By looking at all pairs of cells.
template <int D>
std::vector<int> bruteForce(const VoxelGrid<D> &grid, GridBorder border)
{
    std::vector<int> squares(grid.cells(), noSquaredDistance);
    for (int cell = 0; cell < grid.cells(); ++cell)
    {
        for (int other = 0; other < grid.cells(); ++other)
            if (grid.occupied(other))
                squares[cell] = std::min(squares[cell], (grid.index(cell) - grid.index(other)).squaredNorm());
        for (int axis = 0; axis < D && border == GridBorder::Wall; ++axis)
        {
            const int below = grid.index(cell)[axis] + 1, above = grid.counts()[axis] - grid.index(cell)[axis];
            squares[cell] = std::min({squares[cell], below * below, above * above});
        }
    }
    return squares;
}

template <int D>
void expectBruteForce(const Eigen::Matrix<double, D, 1> &size)
{
    std::mt19937 generator(5);
    for (double share : {0.002, 0.02, 0.3, 1.0})
        for (GridBorder border : {GridBorder::Open, GridBorder::Wall})
        {
            auto grid = VoxelGrid<D>::make(Eigen::Matrix<double, D, 1>::Zero(), size, 1.0).grid;
            for (int cell = 0; cell < grid.cells(); ++cell)
                if (std::bernoulli_distribution(share)(generator))
                    grid.occupy(cell);
            EXPECT_EQ(squaredDistances(grid, border), bruteForce(grid, border)) << share;
        }
}

TEST(DistanceField, EqualsBruteForceInThePlane)
{
    expectBruteForce<2>({41.0, 29.0});
    expectBruteForce<2>({1.0, 60.0});
}

TEST(DistanceField, EqualsBruteForceInSpace)
{
    expectBruteForce<3>({13.0, 9.0, 17.0});
}

TEST(DistanceField, IsInfiniteWhereNothingIsOccupied)
{
    const auto grid = VoxelGrid<2>::make({0, 0}, {3, 1}, 0.5).grid;
    EXPECT_EQ(squaredDistances(grid, GridBorder::Open), std::vector<int>(12, noSquaredDistance));
    EXPECT_TRUE(std::isinf(distanceField(grid, GridBorder::Open)[0]));
    // Two rows in a wall: everything is one cell away from it.
    EXPECT_EQ(distanceField(grid, GridBorder::Wall), std::vector<float>(12, 0.5F));
}

TEST(DistanceField, HoldsTheLargestGridsSquares)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {40000.0, 1.0}, 1.0).grid;
    grid.occupy(0);
    EXPECT_EQ(squaredDistances(grid, GridBorder::Open).back(), 39999 * 39999);
}

TEST(DistanceField, BoundsTheTrueDistanceAsPromised)
{
    const double h = 0.125, room = 0.5 * h * std::sqrt(2.0) * 1.0001;
    const Circle first{{1.3, 1.1}, 0.6}, second{{3.2, 2.4}, 0.35};
    auto grid = VoxelGrid<2>::make({0, 0}, {5, 4}, h).grid;
    occupyCells(grid, {{"a", first}, {"b", second}}, room);
    const std::vector<float> field = distanceField(grid, GridBorder::Open);
    for (int cell = 0; cell < grid.cells(); ++cell)
    {
        const Eigen::Vector2d p = grid.center(cell);
        const double truth =
            std::min((p - first.center).norm() - first.radius, (p - second.center).norm() - second.radius);
        if (truth < 0.0)
            continue;
        EXPECT_GE(truth, field[cell] - 0.5 * h * std::sqrt(2.0) - 1e-6);
        EXPECT_LE(truth, field[cell] + room + 1e-6);
    }
}
}  // namespace
}  // namespace narrows
