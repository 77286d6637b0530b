// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/beams/CriticalRegion.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double degree = M_PI / 180.0;

/// A path that goes along x, once around the origin's part of a circle of radius 2 to the left, and on, 10 straight
/// before and behind.
PointPath<2> bend(double angle)
{
    const Vector2d center(0.0, 2.0);
    PointPath<2> path{{-10.0, 0.0}};
    for (int i = 0; i <= 90; ++i)
        path.push_back(center + 2.0 * Vector2d(std::sin(angle * i / 90), -std::cos(angle * i / 90)));
    path.push_back(path.back() + 10.0 * Vector2d(std::cos(angle), std::sin(angle)));
    return path;
}

/// Walls at one unit to both sides of that path, as far as beams see: closed forms of a straight piece and a circle.
double besideBend(const Vector2d &point, double angle)
{
    const Vector2d fromCenter = point - Vector2d(0.0, 2.0);
    const Vector2d ahead(std::cos(angle), std::sin(angle));
    const double along = fromCenter.dot(ahead);
    double away = std::abs(fromCenter.norm() - 2.0);
    if (point.x() < 0.0)
        away = std::abs(point.y());
    else if (along > 0.0)
        away = std::abs(fromCenter.dot(Vector2d(ahead.y(), -ahead.x())) - 2.0);
    return 1.0 - away;
}

BeamFan<2> fanOfBend(double angle)
{
    BeamFanOptions options;
    options.linkLength = 3.0;
    options.spacing = 0.1;
    return castBeams<2>(
        bend(angle), [angle](const Vector2d &point) { return besideBend(point, angle); }, options);
}

TEST(BeamFan, EndsAHundredthOfTheSpacingBeforeTheWall)
{
    BeamFanOptions options;
    options.linkLength = 3.0;
    options.spacing = 0.5;
    options.radius = 0.2;
    const PointPath<2> middle{{0.0, 0.3}, {10.0, 0.3}};
    const auto corridor = [](const Vector2d &point)
    {
        return 1.0 - std::abs(point.y());
    };
    const BeamFan<2> fan = castBeams<2>(middle, corridor, options);
    ASSERT_EQ(fan.count(), 21);
    ASSERT_EQ(fan.couples.size(), 1u);
    for (int i = 0; i < fan.count(); ++i)
    {
        EXPECT_NEAR(fan.end(0, 0, i).y(), 1.0 - 0.2 - 0.005, 1e-4);
        EXPECT_NEAR(fan.end(0, 1, i).y(), -1.0 + 0.2 + 0.005, 1e-4);
        EXPECT_NEAR(fan.clearance[i], 0.5, 1e-12);
    }
}

TEST(BeamFan, ShortensBeamsInOpenSpaceAtTheEndsOnly)
{
    BeamFanOptions options;
    options.linkLength = 3.0;
    options.spacing = 0.5;
    // A corridor of half-width 1 from x = 5 to 15 and again from 25 on, open space around and between.
    const auto slit = [](const Vector2d &point)
    {
        const auto wall = [&point](double from, double to)
        {
            return Vector2d(std::max({from - point.x(), point.x() - to, 0.0}), std::max(1.0 - std::abs(point.y()), 0.0))
                .norm();
        };
        return std::min(wall(5.0, 15.0), wall(25.0, 60.0));
    };
    const BeamFan<2> fan = castBeams<2>({{0.0, 0.0}, {60.0, 0.0}}, slit, options);
    EXPECT_DOUBLE_EQ(fan.typicalClearance, 1.0);
    EXPECT_DOUBLE_EQ(fan.couples[0].lengths[0].front(), 1.0);
    EXPECT_DOUBLE_EQ(fan.couples[0].lengths[0][40], openBeamLinks * 3.0) << "not between two passages";
}

TEST(BeamFan, CarriesItsFrameWithoutTurningAboutThePath)
{
    // Along a helix of radius a and pitch 2 pi b, a frame without rotation turns against the curve's own by the torsion
    // b / (a^2 + b^2) per length.
    const double a = 2.0, b = 0.7, c = std::hypot(a, b);
    PointPath<3> helix;
    for (int i = 0; i <= 4000; ++i)
        helix.emplace_back(a * std::cos(i * 2e-3), a * std::sin(i * 2e-3), b * i * 2e-3);
    BeamFanOptions options;
    options.linkLength = 1.0;
    options.spacing = 0.01;
    options.couples = 4;
    const BeamFan<3> fan = castBeams<3>(
        helix, [](const Vector3d &) { return 100.0; }, options);
    const auto phase = [&](int station)
    {
        const double t = station * fan.spacing / c;
        const Vector3d inwards(-std::cos(t), -std::sin(t), 0.0);
        const Vector3d u = fan.couples[0].directions[station];
        return std::atan2(u.dot(fan.tangents[station].cross(inwards)), u.dot(inwards));
    };
    // Not from the very ends, where tangents are one-sided.
    const int from = 20, to = fan.count() - 21;
    const double expected = -(to - from) * fan.spacing * b / (c * c);
    EXPECT_NEAR(std::remainder(phase(to) - phase(from) - expected, 2.0 * M_PI), 0.0, 1e-3);
    for (int m = 0; m < 4; ++m)
        for (const int station : {0, 100, fan.count() - 1})
        {
            const Vector3d direction = fan.couples[m].directions[station];
            EXPECT_NEAR(direction.dot(fan.tangents[station]), 0.0, 1e-12);
            EXPECT_NEAR(direction.dot(fan.couples[0].directions[station]), std::cos(m * M_PI / 4), 1e-12);
        }
}

TEST(CriticalRegion, IsTheInnerSideOfABend)
{
    const auto regions = findCriticalRegions(fanOfBend(90 * degree), standardRegions<2>(2.0));
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_EQ(regions[0].side, 0) << "left, where the path turns";
    EXPECT_NEAR(regions[0].turning, 90 * degree, 6 * degree);
    // The bend is from 10 to 10 + pi along the path; far ends inside move half as fast, outside half as fast again.
    EXPECT_NEAR(regions[0].first, 100, 2);
    EXPECT_NEAR(regions[0].last, 131, 2);
}

TEST(CriticalRegion, LooksAtBothSidesAndAtTheTurning)
{
    EXPECT_TRUE(findCriticalRegions(fanOfBend(12 * degree), standardRegions<2>(2.0)).empty());
    EXPECT_EQ(findCriticalRegions(fanOfBend(25 * degree), standardRegions<2>(2.0)).size(), 1u);
    // Inner ends go half the way and outer ones one and a half times: a third of them.
    CriticalRegionOptions options = standardRegions<2>(2.0);
    options.ratio = 0.32;
    EXPECT_TRUE(findCriticalRegions(fanOfBend(90 * degree), options).empty());
    options.ratio = 0.6;
    options.slow = 0.48;
    EXPECT_TRUE(findCriticalRegions(fanOfBend(90 * degree), options).empty());
}

/// A path along x, bent to the side of `to` and again, with walls that the beams of each couple meet where it says.
BeamFan<3> handMadeFan(const std::vector<std::array<int, 4>> &runs)
{
    BeamFan<3> fan;
    fan.spacing = 1.0;
    for (int i = 0; i <= 60; ++i)
    {
        fan.stations.emplace_back(i, 0.0, 0.0);
        fan.tangents.push_back(Vector3d(std::cos(0.1 * i), std::sin(0.1 * i), 0.0));
        fan.clearance.push_back(1.0);
    }
    for (int couple = 0; couple < 2; ++couple)
    {
        BeamCouple<3> beams;
        beams.directions.assign(61, couple == 0 ? Vector3d::UnitX() : Vector3d::UnitY());
        for (auto &lengths : beams.lengths)
            lengths.assign(61, 1.0);
        fan.couples.push_back(beams);
    }
    // {couple, side, from, to}: ends that stand still along x on one side; on the other they move twice as fast.
    for (const auto &[couple, side, from, to] : runs)
        for (int i = from; i <= to + 1; ++i)
        {
            fan.couples[couple].lengths[side][i] = 100.0 + (side == 0 ? -0.9 : 0.9) * (i - from);
            fan.couples[couple].lengths[1 - side][i] = 100.0 + (side == 0 ? -1.0 : 1.0) * (i - from);
        }
    return fan;
}

TEST(CriticalRegion, MergesRunsThatAreCloserThanTheGap)
{
    const BeamFan<3> fan = handMadeFan({{0, 0, 10, 14}, {0, 0, 18, 22}});
    CriticalRegionOptions options;
    options.turning = 0.2;
    EXPECT_EQ(findCriticalRegions(fan, options).size(), 2u);
    options.gap = 4.0;
    const auto merged = findCriticalRegions(fan, options);
    ASSERT_EQ(merged.size(), 1u);
    EXPECT_EQ(merged[0].first, 10);
    EXPECT_EQ(merged[0].last, 22);
    EXPECT_NEAR(merged[0].turning, 10 * 0.1, 1e-9) << "over its critical stations only";
}

TEST(CriticalRegion, OfTwoInOnePlaceTheWeightierRemains)
{
    CriticalRegionOptions options;
    options.turning = 0.2;
    const auto apart = findCriticalRegions(handMadeFan({{0, 0, 10, 14}, {0, 0, 30, 40}}), options);
    ASSERT_EQ(apart.size(), 2u);
    EXPECT_LT(apart[0].last, apart[1].first) << "in the order of the path";
    BeamFan<3> fan = handMadeFan({{0, 0, 10, 20}});
    fan.couples.push_back(fan.couples[0]);
    for (int i = 13; i < 30; ++i)
        fan.couples[2].lengths[0][i] = fan.couples[2].lengths[0][12];
    const auto kept = findCriticalRegions(fan, options);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].couple, 0);
    EXPECT_EQ(kept[0].last, 20);
}
}  // namespace
}  // namespace narrows
