// SPDX-License-Identifier: BSD-3-Clause
// Step 4: the tip's way.
#include <cmath>

#include <gtest/gtest.h>

#include "Sections.h"
#include "kernel/scaling/TipPath.h"
#include "kernel/scaling/TipRoutes.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

double lengthOf(const std::vector<Vector2d> &corners)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        sum += (corners[i] - corners[i - 1]).norm();
    return sum;
}

double clearanceOf(const std::vector<Vector2d> &corners, const std::vector<ConvexSection> &sections)
{
    double least = 1e300;
    for (const ConvexSection &section : sections)
        for (std::size_t i = 1; i < corners.size(); ++i)
            least = std::min(least, section.distance(corners[i - 1], corners[i]));
    return least;
}

TEST(TipRoutes, FreeLegsAreStraight)
{
    const TipRoutes routes({disc(0.0, 5.0, 1.0)}, {1.0}, {{-5.0, 0.0}, {5.0, 0.0}, {5.0, 2.0}});
    ASSERT_FALSE(routes.fault());
    EXPECT_EQ(routes.legs(), 2U);
    EXPECT_EQ(routes.choices(), 0U);
    EXPECT_EQ(routes.leg(0, {}), (std::vector<Vector2d>{{-5.0, 0.0}, {5.0, 0.0}}));
}

TEST(TipRoutes, BypassIsTheShortestOnItsSide)
{
    const std::vector<ConvexSection> sections{disc(0.0, 0.5, 1.0)};
    const TipRoutes routes(sections, std::vector<double>(sections.size(), 1.0), {{-5.0, 0.0}, {5.0, 0.0}});
    ASSERT_EQ(routes.choices(), 1U);
    // Two tangents of the circle of radius 2 and the arc between them.
    const auto around = [](double height)
    {
        const double distance = std::hypot(5.0, height);
        const double tangent = std::sqrt(distance * distance - 4.0);
        const double seen = std::acos(2.0 / distance) + std::atan2(height, 5.0);
        return 2.0 * tangent + 2.0 * (std::acos(-1.0) - 2.0 * seen);
    };
    const std::vector<Vector2d> below = routes.leg(0, {});
    const std::vector<Vector2d> above = routes.leg(0, {true});
    EXPECT_NEAR(lengthOf(below), around(0.5), 0.01);
    EXPECT_NEAR(lengthOf(above), around(-0.5), 0.01);
    EXPECT_LT(below[1].y(), 0.0);
    EXPECT_GT(above[1].y(), 0.0);
    EXPECT_GT(clearanceOf(below, sections), 0.99);
    EXPECT_GT(clearanceOf(above, sections), 0.99);
    EXPECT_GT(routes.detour(0), 0.0);
}

TEST(TipRoutes, EveryRegionOnALegIsAChoice)
{
    const std::vector<ConvexSection> sections{disc(-3.0, 0.1, 0.5), disc(3.0, -0.1, 0.5)};
    const TipRoutes routes(sections, std::vector<double>(sections.size(), 0.5), {{-6.0, 0.0}, {6.0, 0.0}, {-6.0, 0.0}});
    ASSERT_EQ(routes.choices(), 4U);
    for (int mask = 0; mask < 16; ++mask)
    {
        const std::vector<bool> longer{(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0};
        for (std::size_t leg = 0; leg < 2; ++leg)
        {
            const std::vector<Vector2d> corners = routes.leg(leg, longer);
            EXPECT_GT(clearanceOf(corners, sections), 0.49) << mask;
            EXPECT_LT(lengthOf(corners), 14.0);
        }
    }
    EXPECT_NE(routes.leg(0, {true, false, false, false}), routes.leg(0, {}));
    EXPECT_EQ(routes.leg(0, {false, false, true, true}), routes.leg(0, {}));
}

TEST(TipRoutes, RegionsBetweenLegAndBaseMayBePassedOnTheBasesSide)
{
    const std::vector<ConvexSection> sections{disc(4.0, 0.0, 0.5), disc(-4.0, 0.0, 0.5)};
    const TipRoutes routes(sections, {0.5, 0.5}, {{6.0, -4.0}, {6.0, 4.0}});
    ASSERT_EQ(routes.choices(), 1U);
    EXPECT_EQ(routes.leg(0, {}).size(), 2U);
    const std::vector<Vector2d> inner = routes.leg(0, {true});
    EXPECT_GT(clearanceOf(inner, sections), 0.49);
    double least = 1e300;
    for (const Vector2d &corner : inner)
        least = std::min(least, corner.x());
    EXPECT_NEAR(least, 3.0, 0.01);  // around the left of the region of radius 1
    // The tangents from (6, +-4), at sqrt(20) from the centre, and the arc between them.
    const double seen = std::acos(1.0 / std::sqrt(20.0)) + std::acos(2.0 / std::sqrt(20.0));
    EXPECT_NEAR(lengthOf(inner), 2.0 * std::sqrt(19.0) + 2.0 * (std::acos(-1.0) - seen), 0.01);
    EXPECT_NEAR(routes.detour(0), lengthOf(inner) - 8.0, 1e-12);
    EXPECT_EQ(TipRoutes(sections, {0.5, 0.5}, {{3.0, -6.0}, {-3.0, -6.0}}).choices(), 0U);
}

TEST(TipRoutes, OverlappingRegionsArePassedAsOne)
{
    const std::vector<ConvexSection> sections{disc(0.0, -1.4, 0.5), disc(0.0, 1.4, 0.5), disc(0.0, 0.0, 0.5)};
    const TipRoutes routes(sections, std::vector<double>(sections.size(), 0.5), {{-6.0, 0.3}, {6.0, 0.3}});
    ASSERT_FALSE(routes.fault());
    ASSERT_EQ(routes.choices(), 1U);
    const std::vector<Vector2d> above = routes.leg(0, {});
    EXPECT_GT(clearanceOf(above, sections), 0.49);
    EXPECT_GT(above[1].y(), 2.0);
    EXPECT_LT(routes.leg(0, {true})[1].y(), -2.0);
}

TEST(TipPath, LegsAreDenseAndExact)
{
    std::vector<Vector3d> tips{{10.0, 0.0, 0.0}};
    appendLeg({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, 17.0, 0.5, 0.0, tips);
    EXPECT_EQ(tips.back(), Vector3d(17.0, 3.0, 4.0));
    bool corner = false;
    for (std::size_t i = 1; i < tips.size(); ++i)
    {
        EXPECT_LE((tips[i] - tips[i - 1]).norm(), 0.5 + 1e-12);
        corner = corner || tips[i].tail<2>() == Vector2d(3.0, 0.0);
    }
    EXPECT_TRUE(corner);
}

TEST(TipPath, RetractionIsASemicircle)
{
    std::vector<Vector3d> tips{{10.0, 0.0, 0.0}};
    appendLeg({{0.0, 0.0}, {100.0, 0.0}}, 10.0, 1.0, 50.0, tips);
    ASSERT_EQ(tips.size(), 101U);
    EXPECT_NEAR(tips[50].x(), -40.0, 1e-12);
    EXPECT_NEAR(tips[10].x(), 10.0 - std::sqrt(2500.0 - 1600.0), 1e-12);
    EXPECT_EQ(tips[100].x(), 10.0);
}

TEST(TipPath, EntriesAreThoseOfThePaper)
{
    // The square of Figure 6: A1 -> A2 is the shortest distance, A4' and B2 are equidistant points.
    const std::vector<Vector2d> square{
        {1000.0, -200.0}, {1000.0, 1300.0}, {-500.0, 1300.0}, {-500.0, -200.0}, {1000.0, -200.0}};
    const Vector2d start = Vector2d::Zero();
    EXPECT_EQ(nearestEntry(square, start).point, Vector2d(0.0, -200.0));
    EXPECT_EQ(nearestEntry(square, start).segment, 3U);
    const std::optional<PathEntry> b2 = equidistantEntry(square, start, {400.0, 400.0});
    ASSERT_TRUE(b2);
    EXPECT_LT((b2->point - Vector2d(1000.0, 1000.0)).norm(), 1e-9);
    const std::optional<PathEntry> a4 = equidistantEntry(square, start, {700.0, 600.0});
    ASSERT_TRUE(a4);
    EXPECT_LT((a4->point - Vector2d(1000.0, 6000.0 / 7.0)).norm(), 1e-9);
    EXPECT_FALSE(equidistantEntry({{-1.0, 1.0}, {-1.0, -1.0}}, start, {1.0, 0.0}));
    const std::optional<PathEntry> nearest =
        nearestEquidistantEntry(square, start, {{400.0, 400.0}, {700.0, 600.0}, {-100.0, 500.0}});
    ASSERT_TRUE(nearest);
    EXPECT_LT((nearest->point - Vector2d(1000.0, 6000.0 / 7.0)).norm(), 1e-9);
}
}  // namespace
}  // namespace narrows
