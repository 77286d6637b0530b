// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SliceOracle.h"

#include <cmath>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
/// The plane itself: w = (s, lambda), goal at (0, 1).
class Plane : public HomotopyCurve
{
public:
    explicit Plane(int equations = 1) : equations_(equations) {}
    int equations() const override { return equations_; }
    double lambdaScale() const override { return 1.0; }
    Eigen::VectorXd startPoint() const override { return Eigen::Vector2d(0.0, 0.0); }
    Eigen::VectorXd goalPoint() const override { return Eigen::Vector2d(0.0, 1.0); }
    void evaluate(CurvePoint &) const override {}
    void configuration(const Eigen::VectorXd &z, Eigen::VectorXd &w) const override { w = z; }

private:
    int equations_;
};

using Clearance = std::function<double(const Eigen::VectorXd &)>;

/// A wall across the way at lambda = 0.5, with holes at s = `holes` of the given half widths. Distances to it.
Clearance wall(const std::vector<std::pair<double, double>> &holes)
{
    return [holes](const Eigen::VectorXd &z)
    {
        const double beside = std::abs(z[1] - 0.5) - 0.05;
        double best = beside;
        for (const auto &[center, half] : holes)
            best = std::max(best, half - std::abs(z[0] - center));
        return best;
    };
}

/// Steps of a thousandth: fine enough for the walls here.
SliceAnswer explore(const Clearance &clearance)
{
    const auto isFree = [&](const Eigen::VectorXd &a, const Eigen::VectorXd &b)
    {
        const int steps = 1 + static_cast<int>((b - a).norm() / 1e-3);
        for (int i = 0; i <= steps; ++i)
            if (!(clearance(a + i * (b - a) / steps) > 0.0))
                return false;
        return true;
    };
    return exploreSlice(Plane(), clearance, isFree);
}

TEST(SliceOracle, FindsTheHole)
{
    const SliceAnswer answer = explore(wall({{1.0, 0.2}}));
    ASSERT_TRUE(answer.joins);
    EXPECT_NEAR(answer.bottleneck, 0.2, 0.04);
    EXPECT_EQ(answer.path.front(), Eigen::VectorXd(Eigen::Vector2d(0.0, 0.0)));
    EXPECT_EQ(answer.path.back(), Eigen::VectorXd(Eigen::Vector2d(0.0, 1.0)));
}

TEST(SliceOracle, TakesTheWiderOfTwoHoles)
{
    const SliceAnswer answer = explore(wall({{0.3, 0.1}, {-2.0, 0.3}}));
    ASSERT_TRUE(answer.joins);
    EXPECT_NEAR(answer.bottleneck, 0.3, 0.04);
    double least = 0.0;
    for (const Eigen::VectorXd &z : answer.path)
        least = std::min(least, z[0]);
    EXPECT_LT(least, -1.6);
}

TEST(SliceOracle, SeesThatAWallHasNoHole)
{
    const SliceAnswer answer = explore(wall({}));
    EXPECT_FALSE(answer.joins);
    EXPECT_EQ(answer.bottleneck, 0.0);
    EXPECT_TRUE(answer.path.empty());
    // Nor is there one where nobody looks.
    EXPECT_FALSE(explore(wall({{5.0, 0.5}})).joins);
}

TEST(SliceOracle, SeesThatAnEndIsBlocked)
{
    const Clearance open = [](const Eigen::VectorXd &)
    {
        return 1.0;
    };
    EXPECT_TRUE(explore(open).joins);
    EXPECT_FALSE(explore([](const Eigen::VectorXd &z) { return z.norm() - 0.1; }).joins);
    EXPECT_FALSE(explore([](const Eigen::VectorXd &z) { return (z - Eigen::Vector2d(0.0, 1.0)).norm() - 0.1; }).joins);
}

TEST(SliceOracle, LeavesANarrowWedge)
{
    // Free is a wedge of 20 degrees either side of the s axis, whose apex is a millionth before the goal.
    const Clearance wedge = [](const Eigen::VectorXd &z)
    {
        const double s = z[0] + 1e-6, across = std::abs(z[1] - 1.0);
        const double inside = s * std::sin(0.35) - across * std::cos(0.35);
        return z[1] < 0.5 ? 0.5 : inside > 0.0 && s < 2.0 ? inside : s >= 1.5 ? 0.1 : -0.1;
    };
    EXPECT_TRUE(explore(wedge).joins);
}

TEST(SliceOracle, RefusesWhatItCannotExplore)
{
    const auto free = [](const Eigen::VectorXd &)
    {
        return 1.0;
    };
    const auto yes = [](const Eigen::VectorXd &, const Eigen::VectorXd &)
    {
        return true;
    };
    EXPECT_THROW(exploreSlice(Plane(2), free, yes), std::invalid_argument);
    SliceWindow window;
    window.lambdaMax = 0.9;
    EXPECT_THROW(exploreSlice(Plane(), free, yes, window), std::invalid_argument);
    window = {};
    window.rows = 1;
    EXPECT_THROW(exploreSlice(Plane(), free, yes, window), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
