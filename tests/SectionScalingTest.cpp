// SPDX-License-Identifier: BSD-3-Clause
// The section plane: convex sections, auxiliary lines, and the rules of a pose.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "PaperSquare.h"
#include "Sections.h"
#include "kernel/Cross.h"
#include "kernel/scaling/PlainScaling.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

ConvexSection triangle()
{
    return ConvexSection({{0.0, 0.0}, {4.0, 0.0}, {0.0, 3.0}}, 0.0);
}

TEST(ConvexSection, KnowsItsDistances)
{
    EXPECT_DOUBLE_EQ(disc(1.0, 2.0, 0.5).distance({4.0, 6.0}), 4.5);
    EXPECT_DOUBLE_EQ(disc(1.0, 2.0, 0.5).distance({-9.0, 3.0}, {9.0, 3.0}), 0.5);
    EXPECT_EQ(disc(1.0, 2.0, 0.5).distance({-9.0, 2.2}, {9.0, 2.2}), 0.0);
    EXPECT_EQ(triangle().distance({0.5, 0.5}), 0.0);
    EXPECT_DOUBLE_EQ(triangle().distance({3.2, 3.4}), 2.24);  // from the long side, 3 y + 4 z = 12
    EXPECT_DOUBLE_EQ(ConvexSection({{0.0, 0.0}, {2.0, 0.0}}, 1.0).distance({1.0, 3.0}), 2.0);
}

TEST(ConvexSection, RefusesWhatIsNone)
{
    EXPECT_THROW(ConvexSection({}, 1.0), std::invalid_argument);
    EXPECT_THROW(ConvexSection({{0.0, 0.0}}, -1.0), std::invalid_argument);
    EXPECT_THROW(ConvexSection({{0.0, std::nan("")}}, 1.0), std::invalid_argument);
    EXPECT_THROW(ConvexSection({{0.0, 0.0}}, 1.0, {2.0, 1.0}), std::invalid_argument);
}

TEST(ConvexSection, ContactSaysWhereTheWayOutIs)
{
    const ConvexSection::Contact contact = disc(0.0, 0.0, 1.0).contact({-2.0, 3.0}, {6.0, 3.0});
    EXPECT_DOUBLE_EQ(contact.distance, 2.0);
    EXPECT_DOUBLE_EQ(contact.fraction, 0.25);
    EXPECT_LT((contact.away - Vector2d(0.0, 1.0)).norm(), 1e-12);
    const ConvexSection::Contact through = triangle().contact({1.0, -1.0}, {1.0, 5.0});
    EXPECT_EQ(through.distance, 0.0);
    EXPECT_DOUBLE_EQ(through.away.norm(), 1.0);
}

TEST(ConvexSection, LinesCrossTheDangerRegionAtItsBoundary)
{
    const std::optional<Interval> hits = disc(1.0, 2.0, 3.0).crossing(0, 5.0, 2.0);
    ASSERT_TRUE(hits);
    EXPECT_DOUBLE_EQ(hits->lower, -3.0);
    EXPECT_DOUBLE_EQ(hits->upper, 5.0);
    EXPECT_FALSE(disc(1.0, 2.0, 3.0).crossing(0, 7.5, 2.0));

    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 5.0);
    const ConvexSection rounded({{0.0, 0.0}, {4.0, 0.0}, {0.0, 3.0}}, 0.25);
    for (int i = 0; i < 1000; ++i)
        for (int axis = 0; axis < 2; ++axis)
        {
            const double height = uniform(generator);
            const std::optional<Interval> found = rounded.crossing(axis, height, 0.5);
            if (!found)
            {
                Vector2d from(-10.0, height), to(10.0, height);
                if (axis == 1)
                    from = Vector2d(height, -10.0), to = Vector2d(height, 10.0);
                EXPECT_GE(rounded.distance(from, to), 0.5 - 1e-12);
                continue;
            }
            for (const double value : {found->lower, found->upper})
            {
                Vector2d hit(value, height);
                if (axis == 1)
                    hit = Vector2d(height, value);
                EXPECT_NEAR(rounded.distance(hit), 0.5, 1e-12);
            }
        }
}

TEST(ConvexSection, DangerPolygonIsInscribedAndConvex)
{
    for (const ConvexSection &section : {disc(1.0, 2.0, 3.0), triangle(), ConvexSection({{0.0, 0.0}, {2.0, 0.0}}, 1.0)})
    {
        const std::vector<Vector2d> polygon = section.dangerPolygon(0.5);
        EXPECT_GE(polygon.size(), 64U);
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Vector2d &next = polygon[(i + 1) % polygon.size()];
            EXPECT_NEAR(section.distance(polygon[i]), 0.5, 1e-12);
            EXPECT_GE(cross(next - polygon[i], polygon[(i + 2) % polygon.size()] - next), 0.0);
            EXPECT_GE(section.distance(polygon[i], next), 0.5 - 0.002 * (0.5 + section.radius()));
        }
    }
}

TEST(ConvexHull, LeavesOutWhatIsInside)
{
    const std::vector<Vector2d> hull =
        convexHull({{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}, {1.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}, {0.0, 0.0}});
    ASSERT_EQ(hull.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(cross(hull[(i + 1) % 4] - hull[i], hull[(i + 2) % 4] - hull[i]), 4.0);
}

TEST(AuxiliaryLines, HitsInsideOtherRegionsAreNoCandidates)
{
    ScalingProblem problem = paperProblem();
    problem.sections = {disc(700.0, 600.0, 200.0)};
    std::vector<Vector2d> points;
    std::size_t alongY = 0;
    ScalingOptions options;
    options.margin = 100.0;
    AuxiliaryLines(problem, options).candidates({700.0, 600.0}, points, alongY);
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(alongY, 2U);
    EXPECT_EQ(points[0], Vector2d(400.0, 600.0));
    EXPECT_EQ(points[3], Vector2d(700.0, 900.0));
    problem.sections.push_back(disc(380.0, 600.0, 1.0));
    AuxiliaryLines(problem, options).candidates({700.0, 600.0}, points, alongY);
    EXPECT_EQ(points.size(), 3U);
    EXPECT_EQ(alongY, 1U);
    AuxiliaryLines(problem, options).candidates({0.0, 0.0}, points, alongY);
    EXPECT_EQ(points, std::vector<Vector2d>{Vector2d::Zero()});
}

TEST(PoseRules, LiftKeepsLengths)
{
    const ScalingProblem problem = paperProblem();
    const PoseRules rules(problem);
    SectionChain chain;
    for (const double fraction : problem.fractions())
        chain.push_back(fraction * Vector2d(1000.0, 1300.0));
    std::vector<Vector3d> centres(9);
    ASSERT_FALSE(rules.lift(chain, 3126.0, centres.data()));
    ASSERT_FALSE(rules.check(centres.data()));
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR((centres[i + 1] - centres[i]).norm(), problem.lengths[i], 1e-9);
    EXPECT_NEAR(centres[0].x(), 464.8, 0.05);
    EXPECT_NEAR(degrees(linkAngles(problem, centres.data())[0]), 31.65, 0.005);
    chain[8] += Vector2d(0.0, 300.0);
    const ScalingFault fault = rules.lift(chain, 3126.0, centres.data());
    EXPECT_EQ(fault.failure, ScalingFailure::Span);
    EXPECT_EQ(fault.link, 7);
}

TEST(PoseRules, SectionsCountOnlyWhereTheyAre)
{
    ScalingProblem problem = paperProblem();
    std::vector<Vector3d> centres;
    for (const double fraction : problem.fractions())
        centres.emplace_back(fraction * 3126.0, 0.0, 0.0);
    const auto failure = [&](double lower, double upper)
    {
        problem.sections = {ConvexSection({{0.0, 250.0}}, 200.0, {lower, upper})};
        return PoseRules(problem).check(centres.data()).failure;
    };
    EXPECT_EQ(failure(3000.0, 3300.0), ScalingFailure::LinkClearance);
    EXPECT_EQ(failure(3190.0, 3300.0), ScalingFailure::None);  // 64 beyond the tip
    EXPECT_EQ(failure(3180.0, 3300.0), ScalingFailure::LinkClearance);
    EXPECT_EQ(failure(-500.0, -62.0), ScalingFailure::None);
}
}  // namespace
}  // namespace narrows
