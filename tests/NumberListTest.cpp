// SPDX-License-Identifier: BSD-3-Clause
#include "planners/NumberList.h"

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
TEST(NumberList, ReadsVectorsAndMatrices)
{
    EXPECT_EQ(parseVector(" 1, -2.5 ,3e-7"), Eigen::Vector3d(1.0, -2.5, 3e-7));
    EXPECT_EQ(parseVector("  ").size(), 0);
    Eigen::Matrix2d expected;
    expected << 1, 2, 3, 4;
    EXPECT_EQ(parseMatrix("1, 2; 3, 4"), expected);
    EXPECT_EQ(parseMatrix("").size(), 0);
}

TEST(NumberList, WritesWhatItReads)
{
    Eigen::MatrixXd matrix(2, 2);
    matrix << 0.1, -1e-300, 1.0 / 3.0, 12345678.9;
    EXPECT_EQ(parseMatrix(toText(matrix)), matrix);
    EXPECT_EQ(toText(Eigen::MatrixXd()), "");
}

TEST(NumberList, RefusesAnythingElse)
{
    for (const char *text : {"1,", "1,,2", "one", "1 2", "nan", "inf", "1e999", "1;2"})
        EXPECT_THROW(parseVector(text), std::invalid_argument) << text;
    for (const char *text : {"1, 2; 3", "1;;2", ";", "1, 2;"})
        EXPECT_THROW(parseMatrix(text), std::invalid_argument) << text;
}
}  // namespace
}  // namespace narrows
