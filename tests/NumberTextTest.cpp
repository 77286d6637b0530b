// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/NumberText.h"

#include <cmath>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
TEST(NumberText, ReadsDecimalNumbers)
{
    EXPECT_EQ(parseNumber("2"), 2.0);
    EXPECT_EQ(parseNumber("-0.5"), -0.5);
    EXPECT_EQ(parseNumber("+1.25"), 1.25);
    EXPECT_EQ(parseNumber("1e-3"), 1e-3);
    EXPECT_EQ(parseNumber(".5"), 0.5);
    EXPECT_EQ(parseNumber("1e-400"), 0.0);
}

TEST(NumberText, TellsWhatIsNotFinite)
{
    EXPECT_EQ(parseNumber(".inf"), INFINITY);
    EXPECT_EQ(parseNumber("-.inf"), -INFINITY);
    EXPECT_EQ(parseNumber("1e400"), INFINITY);
    EXPECT_TRUE(std::isnan(parseNumber(".nan").value()));
}

TEST(NumberText, RefusesEverythingElse)
{
    for (const char *text : {"", " ", "one", "1 m", "1,5", "0x10", "1e", "+-1", "--1", "1 2", "deg"})
    {
        EXPECT_FALSE(parseNumber(text)) << '"' << text << '"';
        EXPECT_FALSE(parseAngle(text)) << '"' << text << '"';
    }
}

TEST(NumberText, ReadsAnglesInBothUnits)
{
    EXPECT_EQ(parseAngle("0.5"), 0.5);
    EXPECT_EQ(parseAngle("0.5 rad"), 0.5);
    EXPECT_EQ(parseAngle("90 deg"), M_PI / 2);
    EXPECT_EQ(parseAngle("-135deg"), -0.75 * M_PI);
    EXPECT_FALSE(parseAngle("90 degrees"));
    EXPECT_FALSE(parseAngle("90 deg deg"));
    EXPECT_FALSE(parseNumber("90 deg"));
}
}  // namespace
}  // namespace narrows
