// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "PaperScenes.h"
#include "PointSampling.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Rows = std::vector<Eigen::VectorXd>;

constexpr unsigned seed = 31;
const double pi = std::acos(-1.0);

Verdict judge(const PlanarModel &model, const Rows &path)
{
    return verify(model, {path.front(), path.back(), {}}, path);
}

/// Random paths that verify() accepts, in the scene of one of the paper's cases, and states that are in collision.
class PathMaker
{
public:
    PathMaker(const PlanarModel &model, std::mt19937 &generator) : model_(model), generator_(generator) {}

    /// 3 to 8 waypoints.
    Rows freePath()
    {
        Rows path{uniformState()};
        while (!judge(model_, path).accepted)
            path = {uniformState()};
        const std::size_t waypoints = 3 + generator_() % 6;
        while (path.size() < waypoints)
        {
            const Eigen::VectorXd next = path.back() + step();
            if (judge(model_, {path.back(), next}).accepted)
                path.push_back(next);
        }
        return path;
    }

    /// Brute force finds it in collision; deep or, on the way there from a free state, only just.
    Eigen::VectorXd collidingState(const Eigen::VectorXd &free, bool justSo)
    {
        Eigen::VectorXd hit = uniformState();
        while (!armHits(model_, hit, linkSamples))
            hit = uniformState();
        Eigen::VectorXd outside = free;
        for (int halving = 0; justSo && halving < 12; ++halving)
        {
            const Eigen::VectorXd middle = 0.5 * (outside + hit);
            (armHits(model_, middle, linkSamples) ? hit : outside) = middle;
        }
        return hit;
    }

private:
    static constexpr int linkSamples = 40;

    Eigen::VectorXd uniformState()
    {
        std::uniform_real_distribution<double> uniform(-pi, pi);
        return Eigen::VectorXd::NullaryExpr(model_.arm.dimension(), [&]() { return uniform(generator_); });
    }

    Eigen::VectorXd step()
    {
        std::normal_distribution<double> normal(0.0, 0.8 / std::sqrt(model_.arm.dimension()));
        return Eigen::VectorXd::NullaryExpr(model_.arm.dimension(), [&]() { return normal(generator_); });
    }

    const PlanarModel &model_;
    std::mt19937 &generator_;
};

/// The corrupted waypoint may be the first or the last; what is asked for moves along, so that only geometry can
/// refuse.
TEST(PathCorruption, NoneOf10000IsAccepted)
{
    std::mt19937 generator(seed);
    for (int trial = 0; trial < 10000; ++trial)
    {
        const PaperScene scene = paperScene(1 + trial % 3);
        PathMaker maker(scene.model, generator);
        Rows path = maker.freePath();
        SCOPED_TRACE("seed " + std::to_string(seed) + ", trial " + std::to_string(trial));
        ASSERT_TRUE(judge(scene.model, path).accepted);
        const std::size_t victim = generator() % path.size();
        path[victim] = maker.collidingState(path[victim], trial % 2 == 0);
        const Verdict verdict = judge(scene.model, path);
        ASSERT_FALSE(verdict.accepted);
        ASSERT_EQ(verdict.reason, "collision");
        ASSERT_GE(verdict.segment, 0);
        ASSERT_LT(verdict.segment, static_cast<int>(path.size()) - 1);
    }
}

/// The reported place, sampled around, does collide: refusals are no mere caution.
TEST(PathCorruption, RefusalsNameAPlaceThatCollides)
{
    std::mt19937 generator(seed);
    for (int trial = 0; trial < 150; ++trial)
    {
        const PaperScene scene = paperScene(1 + trial % 3);
        PathMaker maker(scene.model, generator);
        Rows path = maker.freePath();
        const std::size_t victim = generator() % path.size();
        path[victim] = maker.collidingState(path[victim], false);
        const Verdict verdict = judge(scene.model, path);
        const Eigen::VectorXd &from = path[verdict.segment], &to = path[verdict.segment + 1];
        EXPECT_TRUE(armHits(scene.model, from + verdict.fraction * (to - from), 20000))
            << "seed " << seed << ", trial " << trial << ", link " << verdict.link << ", " << verdict.obstacle;
    }
}

double furthestMotion(const PlanarArm &arm, const Eigen::VectorXd &delta)
{
    double bound = 0.0;
    for (int link = 0; link < arm.linkCount(); ++link)
        bound += arm.links()[link].length * std::abs(delta[link]);
    return bound;
}

/// At steps of 1e-3, brute force finds no collision on what verify() accepts.
TEST(PathCorruption, AcceptedPathsSurviveADenseRecheck)
{
    std::mt19937 generator(seed);
    for (int trial = 0; trial < 24; ++trial)
    {
        const PaperScene scene = paperScene(1 + trial % 3);
        const Rows path = PathMaker(scene.model, generator).freePath();
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
            const Eigen::VectorXd delta = path[i + 1] - path[i];
            const int steps = static_cast<int>(std::ceil(furthestMotion(scene.model.arm, delta) / 1e-3));
            for (int k = 0; k <= steps; ++k)
                ASSERT_FALSE(armHits(scene.model, path[i] + delta * (static_cast<double>(k) / steps), 50))
                    << "seed " << seed << ", trial " << trial << ", segment " << i;
        }
    }
}
}  // namespace
}  // namespace narrows
