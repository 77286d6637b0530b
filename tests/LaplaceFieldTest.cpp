// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/LaplaceField.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "TightScenes.h"
#include "kernel/fields/DistanceField.h"
#include "kernel/fields/FieldStreamline.h"
#include "kernel/fields/LaplaceSweeps.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/// -ln(sinh(a - b) / sinh(a)) for any size of a.
double minusLogSinhRatio(double a, double b)
{
    return b - std::log1p(-std::exp(-2.0 * (a - b))) + std::log1p(-std::exp(-2.0 * a));
}

TEST(LaplaceField, DecaysInADuctOneCellWideAsTheDifferenceEquationSays)
{
    // 4 v_i = v_(i-1) + v_(i+1), v_0 = 1, v_N = 0: v_i = sinh((N - i) k) / sinh(N k) with cosh k = 2; in space 3.
    const int length = 3000;
    const auto plane = VoxelGrid<2>::make({0, 0}, {double(length), 1.0}, 1.0).grid;
    const auto space = VoxelGrid<3>::make({0, 0, 0}, {double(length), 1.0, 1.0}, 1.0).grid;
    const LaplaceField a = LaplaceSystem<2>(plane).solve({0.5, 0.5});
    const LaplaceField b = LaplaceSystem<3>(space).solve({0.5, 0.5, 0.5});
    ASSERT_EQ(a.failure, LaplaceFailure::None);
    for (int i = 0; i < length; i += 7)
    {
        const double k = std::acosh(2.0), m = std::acosh(3.0);
        EXPECT_NEAR(a.phi[i], minusLogSinhRatio(length * k, i * k), 1e-12 * (1.0 + a.phi[i]));
        EXPECT_NEAR(b.phi[i], minusLogSinhRatio(length * m, i * m), 1e-12 * (1.0 + b.phi[i]));
    }
    EXPECT_GT(b.phi.back(), 5000.0);  // e^-5000: a double ends at e^-745
}

TEST(LaplaceField, DecaysInWideDuctsAsTheirFirstModeSays)
{
    // Per cell k with cosh k = 1 + sum over the axes across of (1 - cos(pi / (n + 1))), n cells across; nearly
    // pi sqrt(D - 1) per width.
    const double pi = std::acos(-1.0);
    const int n = 9;
    const auto plane = VoxelGrid<2>::make({0, 0}, {200.0, n}, 1.0).grid;
    const auto space = VoxelGrid<3>::make({0, 0, 0}, {100.0, n, n}, 1.0).grid;
    const LaplaceField a = LaplaceSystem<2>(plane).solve({0.5, 4.5});
    const LaplaceField b = LaplaceSystem<3>(space).solve({0.5, 4.5, 4.5});
    const double across = 1.0 - std::cos(pi / (n + 1));
    for (int row = 0; row < n; ++row)
    {
        const auto at = [&](int x)
        {
            return a.phi[plane.cell({x, row})];
        };
        EXPECT_NEAR((at(120) - at(70)) / 50.0, std::acosh(1.0 + across), 1e-9);
        const auto in = [&](int x)
        {
            return b.phi[space.cell({x, row, 2})];
        };
        EXPECT_NEAR((in(75) - in(55)) / 20.0, std::acosh(1.0 + 2.0 * across), 1e-6);
    }
    EXPECT_NEAR(std::acosh(1.0 + across), pi / (n + 1), 3e-3);
    // Across the duct it is the sine of the mode.
    EXPECT_NEAR(a.phi[plane.cell({100, 0})] - a.phi[plane.cell({100, 4})], -std::log(std::sin(pi / 10.0)), 1e-9);
}

TEST(LaplaceField, IsTheLogarithmInADiscAndTheHyperbolaInABall)
{
    // Radii a little off, so that no center lies on them.
    auto disc = VoxelGrid<2>::make({-1.05, -1.05}, {1.05, 1.05}, 2.1 / 105).grid;
    disc.occupyWithin([](const Vector2d &p) { return 1.0001 - p.norm(); }, 0.0);
    const LaplaceField a = LaplaceSystem<2>(disc).solve({0, 0});
    const auto at = [&](double x, double y)
    {
        return a.phi[disc.cellAround({x, y})];
    };
    EXPECT_NEAR(std::exp(at(0.6, 0.0) - at(0.3, 0.0)), std::log(1 / 0.3) / std::log(1 / 0.6), 0.02);
    EXPECT_NEAR(at(0.42, 0.42), at(-0.42, 0.42), 1e-12);
    EXPECT_NEAR(std::exp(at(0.4, 0.0) - at(0.28, 0.28)), std::log(0.28 * std::sqrt(2.0)) / std::log(0.4), 1e-3);

    auto ball = VoxelGrid<3>::make({-1.05, -1.05, -1.05}, {1.05, 1.05, 1.05}, 2.1 / 21).grid;
    ball.occupyWithin([](const Vector3d &p) { return 1.0001 - p.norm(); }, 0.0);
    const LaplaceField b = LaplaceSystem<3>(ball).solve({0, 0, 0});
    const double near = std::exp(-b.phi[ball.cellAround({0.3, 0, 0})]),
                 far = std::exp(-b.phi[ball.cellAround({0.6, 0, 0})]);
    EXPECT_NEAR(near / far, (1 / 0.3 - 1.0) / (1 / 0.6 - 1.0), 0.05 * near / far);
}

template <int D>
VoxelGrid<D> randomGrid(const Eigen::Matrix<double, D, 1> &size, unsigned seed)
{
    std::mt19937 generator(seed);
    auto grid = VoxelGrid<D>::make(Eigen::Matrix<double, D, 1>::Zero(), size, 1.0).grid;
    for (int cell = 1; cell < grid.cells(); ++cell)
        if (std::bernoulli_distribution(0.25)(generator))
            grid.occupy(cell);
    return grid;
}

/// Values by a dense solver from the equations as the paper prints them.
template <int D>
Eigen::VectorXd denseValues(const VoxelGrid<D> &grid, int goal)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(grid.cells(), grid.cells());
    for (int cell = 0; cell < grid.cells(); ++cell)
        for (int axis = 0; axis < D && cell != goal && !grid.occupied(cell); ++axis)
            for (int sign : {-1, 1})
            {
                auto next = grid.index(cell);
                next[axis] += sign;
                if (grid.contains(next))
                    matrix(cell, grid.cell(next)) = -0.5 / D;
            }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(grid.cells());
    right[goal] = 1.0;
    return matrix.fullPivLu().solve(right);
}

template <int D>
void expectDenseValues(const Eigen::Matrix<double, D, 1> &size)
{
    for (unsigned seed = 0; seed < 5; ++seed)
    {
        const auto grid = randomGrid<D>(size, seed);
        const LaplaceSystem<D> system(grid);
        for (int goal : {0, grid.cells() / 2 + 1, grid.cells() - 1})  // one factor for all of them
        {
            const LaplaceField field = system.solve(grid.center(goal));
            if (grid.occupied(goal))
            {
                EXPECT_EQ(field.failure, LaplaceFailure::GoalBlocked);
                continue;
            }
            const Eigen::VectorXd expected = denseValues(grid, goal);
            LaplaceSweepOptions options;
            options.tolerance = 1e-12;
            options.maxSweeps = 5000;
            const LaplaceField swept = laplaceBySweeps(grid, grid.center(goal), options);
            ASSERT_EQ(swept.failure, LaplaceFailure::None);
            for (int cell = 0; cell < grid.cells(); ++cell)
            {
                EXPECT_NEAR(std::exp(-field.phi[cell]), expected[cell], 1e-13) << cell;
                EXPECT_TRUE(swept.phi[cell] == field.phi[cell] || std::abs(swept.phi[cell] - field.phi[cell]) < 1e-9);
            }
        }
    }
}

TEST(LaplaceField, EqualsADenseSolutionForEveryGoal)
{
    expectDenseValues<2>({15.0, 12.0});
    expectDenseValues<3>({7.0, 6.0, 5.0});
}

TEST(LaplaceField, SaysWhyThereIsNone)
{
    auto grid = VoxelGrid<2>::make({0, 0}, {20, 10}, 1.0).grid;
    grid.occupy(0);
    EXPECT_EQ(LaplaceSystem<2>(grid, 198).failure(), LaplaceFailure::TooManyCells);
    EXPECT_EQ(LaplaceSystem<2>(grid, 198).solve({5, 5}).failure, LaplaceFailure::TooManyCells);
    const LaplaceSystem<2> system(grid, 199);
    EXPECT_EQ(system.solve({5, 5}).failure, LaplaceFailure::None);
    EXPECT_EQ(system.solve({5, 15}).failure, LaplaceFailure::GoalOutside);
    EXPECT_EQ(system.solve({0.5, 0.5}).failure, LaplaceFailure::GoalBlocked);
    EXPECT_EQ(laplaceBySweeps<2>(grid, {0.5, 0.5}).failure, LaplaceFailure::GoalBlocked);
    LaplaceSweepOptions few;
    few.maxSweeps = 1;
    few.tolerance = 1e-9;
    const LaplaceField unfinished = laplaceBySweeps<2>(grid, {5, 5}, few);
    EXPECT_EQ(unfinished.failure, LaplaceFailure::NotConverged);
    EXPECT_GT(unfinished.residual, 1e-9);
    EXPECT_EQ(toText(LaplaceFailure::NotConverged), "not_converged");
}

TEST(LaplaceField, SaysWhenItUnderflows)
{
    // acosh(3) per cell: a long double (here of 80 bits) ends after 6440.
    const auto duct = VoxelGrid<3>::make({0, 0, 0}, {7000, 1, 1}, 1.0).grid;
    EXPECT_EQ(LaplaceSystem<3>(duct).solve({0.5, 0.5, 0.5}).failure, LaplaceFailure::Underflow);
    EXPECT_EQ(laplaceBySweeps<3>(duct, {0.5, 0.5, 0.5}).failure, LaplaceFailure::Underflow);
}

TEST(LaplaceSweeps, CarryAlongALongDuctInAFewSweeps)
{
    const auto duct = VoxelGrid<2>::make({0, 0}, {2000, 5}, 1.0).grid;
    LaplaceSweepOptions options;
    options.tolerance = 1e-10;
    const LaplaceField swept = laplaceBySweeps<2>(duct, {0.5, 2.5}, options);
    const LaplaceField exact = LaplaceSystem<2>(duct).solve({0.5, 2.5});
    ASSERT_EQ(swept.failure, LaplaceFailure::None);
    EXPECT_LE(swept.sweeps, 40);
    for (int cell = 0; cell < duct.cells(); ++cell)
        EXPECT_NEAR(swept.phi[cell], exact.phi[cell], 1e-6);
}

TEST(FieldSample, IsLinearAlongEveryAxis)
{
    const auto grid = VoxelGrid<3>::make({0, 0, 0}, {4, 4, 4}, 1.0).grid;
    const auto product = [](const Vector3d &p)
    {
        return (1.0 + 0.3 * p.x()) * (2.0 - 0.4 * p.y()) * (1.0 + p.z());
    };
    std::vector<double> phi;
    for (int cell = 0; cell < grid.cells(); ++cell)
        phi.push_back(-std::log(product(grid.center(cell))));
    const FieldSample<3> sample(grid, phi);
    for (const Vector3d &p : {Vector3d(1.2, 2.9, 0.7), Vector3d(2.5, 1.5, 1.5), Vector3d(3.1, 0.51, 3.49)})
        EXPECT_NEAR(sample.value(p, 0.0), product(p), 1e-12);
    const Vector3d p(1.8, 2.2, 1.6);
    const Vector3d slope(0.3 * product(p) / (1.0 + 0.3 * p.x()), -0.4 * product(p) / (2.0 - 0.4 * p.y()),
                         product(p) / (1.0 + p.z()));
    EXPECT_TRUE(sample.slope(p).isApprox(slope * std::exp(sample.leastPhi(p)), 1e-12));
}

TEST(FieldStreamline, KeepsToTheMiddleOfTheUTurnsLegs)
{
    const auto grid = uTurn(10.0);
    const LaplaceField field = LaplaceSystem<2>(grid).solve({340, 50});
    const auto line = followField<2>(grid, field.phi, {60, 400}, {340, 50});
    ASSERT_EQ(line.failure, StreamlineFailure::None);
    double atStart = 0.0;
    for (const Vector2d &point : line.path)
        if (point.y() > 200.0 && point.y() < 600.0 && point.x() > 220.0)
            atStart = std::max(atStart, std::abs(point.x() - 340.0));
    EXPECT_LT(atStart, 12.0);  // the streamline leaves the bend near the wall and the field draws it to the middle
    EXPECT_EQ(line.path.back(), Vector2d(340, 50));
}

TEST(FieldStreamline, ReachesTheGoalThroughThePipeWithEitherSolver)
{
    const auto pipe = bentPipe(10.0, 200.0);
    const auto line = bentPipeLine();
    const LaplaceField exact = LaplaceSystem<3>(pipe).solve(line.back());
    const LaplaceField swept = laplaceBySweeps(pipe, line.back());
    ASSERT_EQ(exact.failure, LaplaceFailure::None);
    ASSERT_EQ(swept.failure, LaplaceFailure::None);
    const Vector3d front(220, 240, 60);
    const int start = pipe.cellAround(front);
    EXPECT_NEAR(swept.phi[start], exact.phi[start], 0.1);
    for (const LaplaceField &field : {exact, swept})
        EXPECT_EQ(followField<3>(pipe, field.phi, front, line.back()).failure, StreamlineFailure::None);
}

TEST(FieldStreamline, SaysWhyItEnds)
{
    const auto grid = uTurn(20.0);
    const LaplaceField field = LaplaceSystem<2>(grid).solve({340, 50});
    EXPECT_EQ(followField<2>(grid, field.phi, {-1, 50}, {340, 50}).failure, StreamlineFailure::StartOutside);
    EXPECT_EQ(followField<2>(grid, field.phi, {220, 50}, {340, 50}).failure, StreamlineFailure::StartBlocked);
    EXPECT_EQ(followField<2>(grid, field.phi, {100, 50}, {340, 50}, 10).failure, StreamlineFailure::TooLong);
    EXPECT_EQ(followField<2>(grid, std::vector<double>(grid.cells(), 1.0), {100, 550}, {340, 50}).failure,
              StreamlineFailure::Stalled);
}
}  // namespace
}  // namespace narrows
