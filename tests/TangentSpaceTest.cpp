// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/TangentSpace.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace narrows
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <int Unknowns>
void checkAgainstDefinitions(int n)
{
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    TangentSpace<Unknowns> space;
    for (int trial = 0; trial < 200; ++trial)
    {
        const MatrixXd jacobian = MatrixXd::NullaryExpr(n, n + 1, [&] { return number(generator); });
        const VectorXd residual = VectorXd::NullaryExpr(n, [&] { return number(generator); });
        ASSERT_TRUE(space.factor(jacobian));
        typename TangentSpace<Unknowns>::Vector t, update;
        space.tangent(t);
        EXPECT_NEAR(t.norm(), 1.0, 1e-13);
        EXPECT_LE((jacobian * t).norm(), 1e-13);
        MatrixXd augmented(n + 1, n + 1);
        augmented << jacobian, t.transpose();
        EXPECT_GT(augmented.determinant(), 0.0);
        EXPECT_NEAR(augmented.determinant(), space.determinant(), 1e-12);
        space.solve(residual, update);
        EXPECT_LE((jacobian * update - residual).norm(), 1e-11 * update.norm());
        EXPECT_LE(std::abs(t.dot(update)), 1e-11 * update.norm());  // so it is the shortest
    }
}

TEST(TangentSpace, IsWhatItsDefinitionSays)
{
    checkAgainstDefinitions<2>(1);
    checkAgainstDefinitions<3>(2);
    checkAgainstDefinitions<Eigen::Dynamic>(1);
    checkAgainstDefinitions<Eigen::Dynamic>(2);
    checkAgainstDefinitions<Eigen::Dynamic>(7);
}

TEST(TangentSpace, HandlesColumnsThatNeedNoReflection)
{
    TangentSpace<Eigen::Dynamic> space;
    MatrixXd jacobian = MatrixXd::Identity(3, 4);
    for (const double sign : {1.0, -1.0})
    {
        jacobian(1, 1) = sign;
        ASSERT_TRUE(space.factor(jacobian));
        VectorXd t;
        space.tangent(t);
        MatrixXd augmented(4, 4);
        augmented << jacobian, t.transpose();
        EXPECT_NEAR(augmented.determinant(), 1.0, 1e-15);
    }
}

template <int Unknowns>
void checkRefusals(int n)
{
    TangentSpace<Unknowns> space;
    MatrixXd jacobian = MatrixXd::Zero(n, n + 1);
    EXPECT_FALSE(space.factor(jacobian));
    jacobian = MatrixXd::Identity(n, n + 1);
    EXPECT_TRUE(space.factor(jacobian));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    {
        jacobian(0, n) = bad;
        EXPECT_FALSE(space.factor(jacobian));
    }
}

TEST(TangentSpace, RefusesWhatHasNoTangent)
{
    checkRefusals<2>(1);
    checkRefusals<3>(2);
    checkRefusals<Eigen::Dynamic>(4);
    MatrixXd dependent(2, 3);
    dependent << 1.0, 2.0, 3.0, -2.0, -4.0, -6.0;
    EXPECT_FALSE(TangentSpace<3>().factor(dependent));
}
}  // namespace
}  // namespace narrows
