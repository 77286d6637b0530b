// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "SpatialOracle.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;

using Rows = std::vector<Eigen::VectorXd>;

constexpr unsigned seed = 37;
constexpr int linkSamples = 30;

Verdict judge(const SpatialModel &model, const Rows &path)
{
    VerifierOptions options;
    options.clearanceTolerance = 1e-3;
    return verify(model, {path.front(), path.back()}, path, options);
}

/// A scene for the verifier, and the same for the oracle, which knows boxes only as boxes.
struct Scene
{
    SpatialModel model;
    SpatialModel simple;
};

class SceneMaker
{
public:
    explicit SceneMaker(std::mt19937 &generator) : generator_(generator) {}

    /// A snake or a six-joint arm among one obstacle of every kind.
    Scene make(bool snake)
    {
        const SpatialArm arm = snake ? universalChain({0, 0, 0}, {0.5, 0.5, 0.5, 0.5}, 0.05) : sixJointArm();
        Scene scene{{arm, {}, true}, {arm, {}, true}};
        add(scene, {"ball", Sphere{place(), 0.3}});
        add(scene, {"rod", Capsule{place(), place(), 0.1}});
        add(scene, {"can", Cylinder{place(), unit(), 0.2, 0.4}});
        add(scene, {"pole", Cylinder{place(), unit(), 0.1, std::numeric_limits<double>::infinity()}});
        add(scene, {"box", anyBox()});
        const Box hull = anyBox();
        add(scene, {"wedge", Prism{{{-0.3, -0.2}, {0.4, -0.1}, {0.0, 0.3}}, hull.pose, hull.halfExtents.x()}});
        const Box covered = anyBox();
        scene.model.obstacles.push_back({"mesh", surfaceOf(covered)});
        scene.simple.obstacles.push_back({"mesh", covered});
        return scene;
    }

private:
    static SpatialArm sixJointArm()
    {
        const double right = std::acos(0.0);
        const auto row = [](double d, double a, double alpha)
        {
            return DenavitHartenberg{0.0, d, a, alpha, Interval{-3.0, 3.0}, 0.06};
        };
        return denavitHartenbergArm(Isometry3d::Identity(),
                                    {row(0.4, 0.0, right), row(0.0, 0.6, 0.0), row(0.25, 0.0, right),
                                     row(0.5, 0.0, -right), row(0.0, 0.0, right), row(0.2, 0.0, 0.0)});
    }

    static void add(Scene &scene, const SpatialObstacle &obstacle)
    {
        scene.model.obstacles.push_back(obstacle);
        scene.simple.obstacles.push_back(obstacle);
    }

    double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator_); }
    Vector3d unit()
    {
        return Vector3d::NullaryExpr([this] { return uniform(); }).normalized();
    }
    Vector3d place() { return (1.0 + 0.5 * uniform()) * unit(); }

    Box anyBox()
    {
        const Isometry3d pose = Eigen::Translation3d(place()) * Eigen::AngleAxisd(3.0 * uniform(), unit());
        return {pose, Vector3d::NullaryExpr([this] { return 0.25 + 0.2 * uniform(); })};
    }

    std::mt19937 &generator_;
};

/// Random paths that verify() accepts, and states that are in collision.
class PathMaker
{
public:
    PathMaker(const Scene &scene, std::mt19937 &generator) : scene_(scene), generator_(generator) {}

    /// 3 to 6 waypoints; nothing if the scene leaves no room.
    Rows freePath()
    {
        Rows path;
        for (int attempt = 0; attempt < 300 && path.empty(); ++attempt)
            if (const Eigen::VectorXd row = uniformState(); judge(scene_.model, {row}).accepted)
                path.push_back(row);
        const std::size_t waypoints = 3 + generator_() % 4;
        for (int attempt = 0; attempt < 300 && !path.empty() && path.size() < waypoints; ++attempt)
            if (const Eigen::VectorXd next = path.back() + step(); judge(scene_.model, {path.back(), next}).accepted)
                path.push_back(next);
        return path.size() < waypoints ? Rows() : path;
    }

    /// Brute force finds it in collision; deep or, on the way there from a free state, only just.
    Eigen::VectorXd collidingState(const Eigen::VectorXd &free, bool justSo)
    {
        Eigen::VectorXd hit = uniformState();
        while (!collides(hit))
            hit = uniformState();
        Eigen::VectorXd outside = free;
        for (int halving = 0; justSo && halving < 12; ++halving)
        {
            const Eigen::VectorXd middle = 0.5 * (outside + hit);
            (collides(middle) ? hit : outside) = middle;
        }
        return hit;
    }

    bool collides(const Eigen::VectorXd &row, int samples = linkSamples) const
    {
        return sampledClearance(scene_.simple, row, samples) <= 0.0 ||
               sampledSelfClearance(scene_.model.arm, row, samples / 3) <= 0.0;
    }

private:
    Eigen::VectorXd uniformState()
    {
        std::uniform_real_distribution<double> uniform(-2.5, 2.5);
        return Eigen::VectorXd::NullaryExpr(scene_.model.arm.dimension(), [&] { return uniform(generator_); });
    }

    Eigen::VectorXd step()
    {
        std::normal_distribution<double> normal(0.0, 0.6 / std::sqrt(scene_.model.arm.dimension()));
        return Eigen::VectorXd::NullaryExpr(scene_.model.arm.dimension(), [&] { return normal(generator_); })
            .cwiseMax(-0.4)
            .cwiseMin(0.4);
    }

    const Scene &scene_;
    std::mt19937 &generator_;
};

/// Calls `check(trial, scene, maker, path)` for paths that are free.
template <class Check>
void forFreePaths(int trials, const Check &check)
{
    std::mt19937 generator(seed);
    int scenes = 0;
    for (int trial = 0; trial < trials;)
    {
        ASSERT_LT(++scenes, 10 * trials) << "hardly any scene has room";
        const Scene scene = SceneMaker(generator).make(trial % 2 == 0);
        PathMaker maker(scene, generator);
        const Rows path = maker.freePath();
        if (path.empty())
            continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + ", trial " + std::to_string(trial));
        check(trial, scene, maker, path);
        if (testing::Test::HasFatalFailure())
            return;
        ++trial;
    }
}

/// The corrupted waypoint may be the first or the last; what is asked for moves along, so that only geometry (or a
/// joint limit) can refuse.
TEST(SpatialCorruption, NoneOf10000IsAccepted)
{
    int obstacles = 0, links = 0;
    const auto corrupt = [&](int trial, const Scene &scene, PathMaker &maker, Rows path)
    {
        ASSERT_TRUE(judge(scene.model, path).accepted);
        const std::size_t victim = trial % path.size();
        path[victim] = maker.collidingState(path[victim], trial % 3 == 0);
        const Verdict verdict = judge(scene.model, path);
        ASSERT_FALSE(verdict.accepted);
        ASSERT_TRUE(verdict.reason == "collision" || verdict.reason == "self_collision") << verdict.reason;
        ASSERT_GE(verdict.segment, 0);
        ASSERT_LT(verdict.segment, static_cast<int>(path.size()) - 1);
        ++(verdict.reason == "collision" ? obstacles : links);
    };
    forFreePaths(10000, corrupt);
    EXPECT_GT(obstacles, 1000);
    EXPECT_GT(links, 100);
}

/// The reported place does collide: refusals are no mere caution.
TEST(SpatialCorruption, RefusalsNameAPlaceThatCollides)
{
    const auto corrupt = [](int trial, const Scene &scene, PathMaker &maker, Rows path)
    {
        const std::size_t victim = trial % path.size();
        path[victim] = maker.collidingState(path[victim], false);
        const Verdict verdict = judge(scene.model, path);
        const Eigen::VectorXd &from = path[verdict.segment], &to = path[verdict.segment + 1];
        const Eigen::VectorXd there = from + verdict.fraction * (to - from);
        EXPECT_TRUE(maker.collides(there, 1500))
            << "link " << verdict.link << " and " << verdict.obstacle << verdict.otherLink;
    };
    forFreePaths(60, corrupt);
}

/// Brute force finds no collision on what verify() accepts, and no less clearance than it says.
TEST(SpatialCorruption, AcceptedPathsSurviveADenseRecheck)
{
    const auto recheck = [](int, const Scene &scene, PathMaker &, const Rows &path)
    {
        const Verdict verdict = judge(scene.model, path);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            for (int k = 0; k <= 200; ++k)
            {
                const Eigen::VectorXd row = path[i] + (path[i + 1] - path[i]) * (k / 200.0);
                least = std::min(least, sampledClearance(scene.simple, row, linkSamples));
                least = std::min(least, sampledSelfClearance(scene.model.arm, row, 10));
            }
        EXPECT_LE(verdict.clearance, least);
        EXPECT_GE(verdict.clearance, least - 0.05);
    };
    forFreePaths(60, recheck);
}
}  // namespace
}  // namespace narrows
