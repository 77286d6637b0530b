// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "SpatialOracle.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Rows = std::vector<Eigen::VectorXd>;

const double pi = std::acos(-1.0);

template <class Model>
Verdict judge(const Model &model, const Rows &path, double tolerance = 1e-6)
{
    VerifierOptions options;
    options.clearanceTolerance = tolerance;
    if constexpr (std::is_same_v<Model, PlanarModel>)
        return verify(model, {path.front(), path.back(), {}}, path, options);
    else
        return verify(model, {path.front(), path.back()}, path, options);
}

/// Three equal sides: the last link's tip comes round to the base.
PlanarModel planarArm(double radius, bool selfCollision = true)
{
    return {PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}}, radius), {}, selfCollision};
}

/// The same bent by yaw only; relative angles.
SpatialModel spatialArm(double radius)
{
    return {universalChain({0, 0, 0}, {1.0, 1.0, 1.0}, radius), {}, true};
}

/// Turns by `base`, each link by `bend` against the one before.
Eigen::VectorXd bentPlanar(double base, double bend)
{
    return Eigen::Vector3d(base, base + bend, base + 2 * bend);
}

Eigen::VectorXd bentSpatial(double base, double bend)
{
    return (Eigen::VectorXd(6) << 0.0, base, 0.0, bend, 0.0, bend).finished();
}

void expectClearance(const Verdict &verdict, double exact, double tolerance = 1e-6)
{
    EXPECT_TRUE(verdict.accepted) << verdict.reason << " at " << verdict.segment << "+" << verdict.fraction;
    EXPECT_LE(verdict.clearance, exact);
    EXPECT_GE(verdict.clearance, exact - tolerance - 1e-12);
}

void expectRefusal(const Verdict &verdict, int link, int otherLink)
{
    EXPECT_FALSE(verdict.accepted);
    EXPECT_EQ(verdict.reason, "self_collision");
    EXPECT_EQ(verdict.link, link);
    EXPECT_EQ(verdict.otherLink, otherLink);
    EXPECT_EQ(verdict.segment, 0);
    EXPECT_EQ(verdict.obstacle, "");
}

TEST(SelfCollision, IsMeasuredAndRefused)
{
    // The tip of link 2 is 2 cos(bend) + 1 away from the base, across link 0: 120 degrees close the triangle.
    const double bend = 1.9, gap = 2 * std::cos(bend) + 1;
    for (const double turn : {0.0, 1.0, 20.0})
    {
        expectClearance(judge(planarArm(0.1), {bentPlanar(0, 0), bentPlanar(turn, bend)}), gap - 0.2);
        expectClearance(judge(spatialArm(0.1), {bentSpatial(0, 0), bentSpatial(turn, bend)}), gap - 0.2);
        expectRefusal(judge(planarArm(0.2), {bentPlanar(0, 0), bentPlanar(turn, bend)}), 2, 0);
        expectRefusal(judge(spatialArm(0.2), {bentSpatial(0, 0), bentSpatial(turn, bend)}), 2, 0);
    }
    EXPECT_TRUE(judge(planarArm(0.2, false), {bentPlanar(0, 0), bentPlanar(0, bend)}).accepted);
}

/// Free at both ends, and folded the other way round: link 2 must have swept through link 0.
TEST(SelfCollision, IsSeenBetweenWaypoints)
{
    const double bend = 2.0, reversed = 2 * pi - bend;
    EXPECT_TRUE(judge(planarArm(0.0), {bentPlanar(0, reversed)}).accepted);
    expectRefusal(judge(planarArm(0.0), {bentPlanar(0, bend), bentPlanar(0, reversed)}), 2, 0);
    expectRefusal(judge(spatialArm(0.0), {bentSpatial(0, bend), bentSpatial(0, reversed)}), 2, 0);
    expectRefusal(judge(planarArm(0.0), {bentPlanar(0, bend), bentPlanar(40, reversed)}), 2, 0);
    EXPECT_TRUE(judge(planarArm(0.0), {bentPlanar(0, bend), bentPlanar(40, -bend)}).accepted);
}

TEST(SelfCollision, TellsFreeFromTouching)
{
    for (const double clearance : {1e-5, 1e-7, 1e-9})
    {
        const double touching = std::acos(-0.4);  // leaves a gap of 0.2
        const double bend = std::acos(-0.4 + 0.5 * clearance), deeper = std::acos(-0.4 - 0.5 * clearance);
        ASSERT_LT(bend, touching);
        expectClearance(judge(planarArm(0.1), {bentPlanar(0, 1), bentPlanar(3, bend), bentPlanar(5, 1)}), clearance);
        expectClearance(judge(spatialArm(0.1), {bentSpatial(0, 1), bentSpatial(3, bend)}), clearance);
        expectRefusal(judge(planarArm(0.1), {bentPlanar(0, 1), bentPlanar(3, deeper)}), 2, 0);
        expectRefusal(judge(spatialArm(0.1), {bentSpatial(0, 1), bentSpatial(3, deeper)}), 2, 0);
    }
}

TEST(SelfCollision, IsNoMatterOfLinksThatMeet)
{
    // Fingers on one tip, folded onto each other and onto their carrier.
    const PlanarModel gripper{PlanarArm({0, 0}, {{1.0, -1}, {0.5, 0}, {0.4, 0}}, 0.05), {}, true};
    EXPECT_TRUE(judge(gripper, {Eigen::Vector3d(0, pi, pi), Eigen::Vector3d(1, pi + 1, pi + 1)}).accepted);
    EXPECT_EQ(judge(gripper, {Eigen::Vector3d(0, 1, 2)}).clearance, std::numeric_limits<double>::infinity());
}

double sampledSelfClearance(const PlanarArm &arm, const Eigen::VectorXd &q, int samples)
{
    std::vector<Eigen::Vector2d> points;
    arm.place(q, points);
    const auto pointOf = [&](int link, int k)
    {
        const Eigen::Vector2d &from = points[arm.links()[link].parent + 1], &to = points[link + 1];
        return Eigen::Vector2d(from + (to - from) * (static_cast<double>(k) / samples));
    };
    double least = std::numeric_limits<double>::infinity();
    for (int link = 2; link < arm.linkCount(); ++link)
        for (int other = 0; other < link - 1; ++other)
            for (int k = 0; k <= samples; ++k)
                for (int j = 0; j <= samples; ++j)
                    least = std::min(least, (pointOf(link, k) - pointOf(other, j)).norm() - 2 * arm.radius());
    return least;
}

/// Against points on both links at states close together: accepted iff they are apart, with their clearance.
template <class Model>
int compareWithSampling(const Model &model, const Rows &path, int index)
{
    constexpr int states = 150, points = 14;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        for (int k = 0; k <= states; ++k)
        {
            const double t = static_cast<double>(k) / states;
            least = std::min(least, sampledSelfClearance(model.arm, (1 - t) * path[i] + t * path[i + 1], points));
        }
    const Verdict verdict = judge(model, path);
    SCOPED_TRACE("seed 43, trial " + std::to_string(index));
    if (verdict.accepted)
    {
        EXPECT_LE(verdict.clearance, least + 1e-12);
        EXPECT_GE(verdict.clearance, least - 0.05);
        return 1;
    }
    EXPECT_EQ(verdict.reason, "self_collision");
    EXPECT_LE(least, 0.05);
    return 0;
}

TEST(SelfCollision, AgreesWithDenseSampling)
{
    std::mt19937 generator(43);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const PlanarModel planar{PlanarArm({0, 0}, {{0.5, -1}, {0.4, 0}, {0.6, 1}, {0.3, 2}, {0.5, 3}}, 0.03), {}, true};
    const SpatialModel spatial{universalChain({0, 0, 0}, {0.5, 0.4, 0.6, 0.3, 0.5}, 0.03), {}, true};
    int accepted = 0;
    constexpr int trials = 60;
    for (int trial = 0; trial < trials; ++trial)
    {
        const auto row = [&](int dimension)
        {
            return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(dimension, [&] { return 2.0 * uniform(generator); }));
        };
        const Eigen::VectorXd flat = row(5), solid = row(10);
        accepted += compareWithSampling(planar, {flat, flat + 0.4 * row(5)}, trial);
        accepted += compareWithSampling(spatial, {solid, solid + 0.4 * row(10)}, trial);
    }
    EXPECT_GT(accepted, trials / 3);
    EXPECT_LT(accepted, 2 * trials - trials / 3);
}
double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool crosses(const PlanarArm &arm, const Eigen::VectorXd &q)
{
    std::vector<Eigen::Vector2d> points;
    arm.place(q, points);
    for (int link = 2; link < arm.linkCount(); ++link)
        for (int other = 0; other < link - 1; ++other)
        {
            const Eigen::Vector2d &a = points[link], &b = points[link + 1], &c = points[other], &d = points[other + 1];
            if (cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0)
                return true;
        }
    return false;
}

/// One waypoint of a free path is replaced by one where two links cross, deep or only just.
TEST(SelfCollision, NoneOf3000CorruptedPathsIsAccepted)
{
    std::mt19937 generator(47);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const PlanarModel model{PlanarArm({0, 0}, {{1, -1}, {1, 0}, {1, 1}, {1, 2}, {1, 3}, {1, 4}}), {}, true};
    const auto row = [&](double size)
    {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(6, [&] { return size * uniform(generator); }));
    };
    for (int trial = 0; trial < 3000; ++trial)
    {
        Rows path{row(0.5)};
        while (path.size() < 4)
            if (const Eigen::VectorXd next = path.back() + row(0.5); judge(model, {path.back(), next}, 1e-3).accepted)
                path.push_back(next);
        SCOPED_TRACE("seed 47, trial " + std::to_string(trial));
        ASSERT_TRUE(judge(model, path, 1e-3).accepted);
        Eigen::VectorXd outside = path[trial % 4], hit = row(pi);
        while (!crosses(model.arm, hit))
            hit = row(pi);
        for (int halving = 0; trial % 2 == 0 && halving < 12; ++halving)
        {
            const Eigen::VectorXd middle = 0.5 * (outside + hit);
            (crosses(model.arm, middle) ? hit : outside) = middle;
        }
        path[trial % 4] = hit;
        ASSERT_EQ(judge(model, path, 1e-3).reason, "self_collision");
    }
}
}  // namespace
}  // namespace narrows
