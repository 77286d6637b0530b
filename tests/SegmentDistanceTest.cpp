// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SegmentDistance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const Polygon notch{{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}};  // a U, open at the top

TEST(SegmentDistance, PointAndSegment)
{
    EXPECT_DOUBLE_EQ(squaredDistance({0, 0}, {2, 0}, {1, 3}), 9.0);
    EXPECT_DOUBLE_EQ(squaredDistance({0, 0}, {2, 0}, {-3, 4}), 25.0);
    EXPECT_DOUBLE_EQ(squaredDistance({0, 0}, {2, 0}, {5, 4}), 25.0);
    EXPECT_DOUBLE_EQ(squaredDistance({1, 1}, {1, 1}, {4, 5}), 25.0);
}

TEST(SegmentDistance, TwoSegments)
{
    EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {1, -1}, {1, 1}), 0.0);
    EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {0, 1}, {2, 1}), 1.0);
    EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {3, 0}, {5, 0}), 1.0);
    EXPECT_DOUBLE_EQ(distance({0, 0}, {2, 0}, {5, 4}, {6, 9}), 5.0);
}

TEST(SegmentDistance, AgreesWithSampling)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto point = [&]()
    {
        return Vector2d(uniform(generator), uniform(generator));
    };
    for (int trial = 0; trial < 300; ++trial)
    {
        const Vector2d a = point(), b = point(), c = point(), d = point();
        double sampled = 10.0;
        for (int i = 0; i <= 400; ++i)
            sampled = std::min(sampled, std::sqrt(squaredDistance(a, b, c + i / 400.0 * (d - c))));
        EXPECT_NEAR(distance(a, b, c, d), sampled, 8e-3) << "trial " << trial;
        EXPECT_LE(distance(a, b, c, d), sampled + 1e-12) << "trial " << trial;
    }
}

TEST(SegmentDistance, APolygonIsSolidAndItsNotchIsNot)
{
    EXPECT_TRUE(contains(notch, {0.5, 2.5}));
    EXPECT_FALSE(contains(notch, {1.5, 2.0}));
    EXPECT_DOUBLE_EQ(distance({0.2, 0.2}, {0.4, 0.3}, notch), 0.0);    // inside, no edge crossed
    EXPECT_DOUBLE_EQ(distance({1.5, 1.25}, {1.5, 5.0}, notch), 0.25);  // down in the notch
    EXPECT_DOUBLE_EQ(distance({1.5, 0.5}, {1.5, 5.0}, notch), 0.0);
    EXPECT_DOUBLE_EQ(distance({-1.0, 2.0}, {4.0, 2.0}, notch), 0.0);
    EXPECT_DOUBLE_EQ(distance({-1.0, 4.0}, {4.0, 4.0}, notch), 1.0);
}
}  // namespace
}  // namespace narrows
