// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SineCosine.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
/// Largest error of `count` random angles up to `range`, against sines worked out with more digits.
double largestError(double range, int blocks)
{
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> angle(-range, range);
    double worst = 0.0;
    for (int b = 0; b < blocks; ++b)
    {
        SineCosineBlock block;
        for (double &value : block.angles)
            value = angle(generator);
        block.evaluate(block.most);
        for (int i = 0; i < block.most; ++i)
        {
            const long double exact = block.angles[i];
            worst = std::max({worst, static_cast<double>(std::abs(block.cosines[i] - std::cos(exact))),
                              static_cast<double>(std::abs(block.sines[i] - std::sin(exact)))});
        }
    }
    return worst;
}

TEST(SineCosine, IsAsExactAsItSays)
{
    EXPECT_LT(largestError(0.1, 2000), 2.5e-16);
    EXPECT_LT(largestError(7.0, 20000), 2.5e-16);
    EXPECT_LT(largestError(1e5, 20000), 2.5e-16);
}

TEST(SineCosine, KnowsTheQuarters)
{
    SineCosineBlock block;
    const double quarter = std::acos(0.0);
    for (int i = 0; i < 9; ++i)
        block.angles[i] = (i - 4) * quarter;
    block.evaluate(9);
    const double cosines[] = {1, 0, -1, 0, 1, 0, -1, 0, 1}, sines[] = {0, 1, 0, -1, 0, 1, 0, -1, 0};
    for (int i = 0; i < 9; ++i)
    {
        EXPECT_NEAR(block.cosines[i], cosines[i], 3e-16) << i;
        EXPECT_NEAR(block.sines[i], sines[i], 5e-16) << i;
    }
    EXPECT_EQ(block.cosines[4], 1.0);
    EXPECT_EQ(block.sines[4], 0.0);
}

TEST(SineCosine, GivesTheSameWhereverInTheBlockAnAngleIs)
{
    SineCosineBlock block;
    for (int count = 1; count <= block.most; ++count)
    {
        for (int i = 0; i < count; ++i)
            block.angles[i] = 0.37;
        block.evaluate(count);
        for (int i = 0; i < count; ++i)
        {
            EXPECT_EQ(block.cosines[i], block.cosines[0]);
            EXPECT_EQ(block.sines[i], block.sines[0]);
        }
    }
}

TEST(SineCosine, LeavesToTheStandardLibraryWhatIsTooLarge)
{
    SineCosineBlock block;
    block.angles[0] = 1.0;
    block.angles[1] = 1e17;
    block.angles[2] = std::numeric_limits<double>::quiet_NaN();
    block.angles[3] = std::numeric_limits<double>::infinity();
    block.evaluate(4);
    EXPECT_EQ(block.sines[0], std::sin(1.0));
    EXPECT_EQ(block.cosines[1], std::cos(1e17));
    EXPECT_TRUE(std::isnan(block.sines[2]));
    EXPECT_TRUE(std::isnan(block.cosines[3]));
}
}  // namespace
}  // namespace narrows
