// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/Rise.h"

#include <random>

#include <gtest/gtest.h>

#include "kernel/trajectory/SmoothEnd.h"

namespace narrows
{
namespace
{
/// Coefficients of a power series: an oracle that knows no formula for derivatives.
using Jet = std::array<long double, 5>;

Jet quotient(const Jet &a, const Jet &b)
{
    Jet q{};
    for (std::size_t k = 0; k < q.size(); ++k)
    {
        q[k] = a[k];
        for (std::size_t i = 0; i < k; ++i)
            q[k] -= q[i] * b[k - i];
        q[k] /= b[0];
    }
    return q;
}

Jet power(long double n, const Jet &exponent)
{
    Jet e{std::pow(n, exponent[0])};
    for (std::size_t k = 1; k < e.size(); ++k)
    {
        for (std::size_t i = 1; i <= k; ++i)
            e[k] += i * exponent[i] * e[k - i];
        e[k] *= std::log(n) / k;
    }
    return e;
}

/// n^t / |n^(t + T/t - 1) - n^a| over its value at T; derivatives by t / T. The paper's formula with n^t cancelled: its
/// derivatives, (T ln n)^k times larger than the result's, would cost the oracle its digits.
Series<4> oracle(long double n, long double a, long double T, long double t)
{
    const auto literal = [&](long double at)
    {
        Jet rest = quotient({T}, {at, 1.0L});
        rest[0] -= 1.0L;
        const Jet first = power(n, rest), second = power(n, {a - at, -1.0L});
        Jet denominator;
        for (std::size_t k = 0; k < denominator.size(); ++k)
            denominator[k] = first[k] - second[k];
        return quotient({1.0L}, denominator);
    };
    const Jet jet = literal(t);
    const long double end = literal(T)[0];
    Series<4> result;
    long double factor = 1.0L / end;
    for (std::size_t k = 0; k < result.size(); factor *= T * ++k)
        result[k] = static_cast<double>(jet[k] * factor);
    return result;
}

struct Shape
{
    double n, a, duration;
};

TEST(TrajectoryRise, AgreesWithTheLiteralFormulaToRounding)
{
    const Shape shapes[] = {{2.5, -1.4, 3.0},     {2.0, 0.05, 1.5},    {1.8, 1.2, 3.0},     {70.0, 2.2, 3.0},
                            {125.0, -100.0, 2.6}, {81.7467, 2.4, 3.0}, {1.91, 0.8734, 1.5}, {5.0, 1.95, 3.0},
                            {2.0, 0.0, 3.0},      {1.001, 0.0, 0.5},   {125.0, 1.0, 200.0}};
    for (const Shape &shape : shapes)
    {
        const Rise rise = *Rise::paper(shape.n, shape.a, shape.duration);
        std::vector<Series<4>> expected, actual;
        Series<4> peak{};
        for (int i = 2; i <= 400; ++i)
        {
            expected.push_back(oracle(shape.n, shape.a, shape.duration, shape.duration * i / 400.0L));
            actual.push_back(rise.at<4>(i / 400.0));
            for (int k = 0; k <= 4; ++k)
                peak[k] = std::max(peak[k], std::abs(expected.back()[k]));
        }
        for (std::size_t i = 0; i < expected.size(); ++i)
            for (int k = 0; k <= 4; ++k)
                EXPECT_NEAR(actual[i][k], expected[i][k], 1e-13 * peak[k]) << shape.n << " order " << k << " at " << i;
    }
}

TEST(TrajectoryRise, BeginsFlatToAllOrdersWhereTheLiteralFormulaIsNotANumber)
{
    const Rise rise = *Rise::paper(125.0, -100.0, 2.6);
    for (const double x : {-1.0, -0.0, 0.0, 1e-308, 1e-300, 1e-9, 1e-3})
        for (const double value : rise.at<4>(x))
            EXPECT_EQ(value, 0.0) << x;
    // ln g = L (t - u) up to 1e-100, and u = T / t + t - 1.
    const double L = std::log(125.0);
    EXPECT_NEAR(std::log(rise.at<0>(0.01)[0]), -99.0 * L, 1e-11);
    EXPECT_EQ(rise.at<3>(1.0)[0], 1.0);
    EXPECT_EQ(rise.at<3>(1.5), (Series<3>{1.0, 0.0, 0.0, 0.0}));
}

TEST(TrajectoryRise, RestingEndsFlatWithTheJerkOfTheClosedForm)
{
    for (const double L : {0.05, 0.62, 1.0, 3.0, 40.0, 600.0})
    {
        const Series<3> end = Rise::resting(L)->at<3>(1.0);
        EXPECT_EQ(end[0], 1.0);
        EXPECT_NEAR(end[1], 0.0, 1e-13 * (L + 2.0));
        EXPECT_NEAR(end[2], 0.0, 1e-12 * (L + 2.0) * (L + 2.0));
        EXPECT_NEAR(end[3], L * (L + 1.0) * (L + 2.0), 1e-11 * std::pow(L + 2.0, 3));
        const double x = 0.4;
        EXPECT_NEAR(Rise::resting(L)->at<0>(x)[0],
                    2.0 / ((L + 2.0) * std::exp(L * (1.0 / x - 1.0)) - L * std::exp((L + 2.0) * (1.0 - x))), 1e-13);
    }
}

TEST(TrajectoryRise, RestingAscendsWhateverItsShape)
{
    for (double L = 0.01; L < 600.0; L *= 1.3)
    {
        const Rise rise = *Rise::resting(L);
        for (int i = 1; i < 500; ++i)
            EXPECT_GE(rise.at<1>(i / 500.0)[1], 0.0) << L << " at " << i;
    }
}

TEST(TrajectoryRise, SymmetricAndQuinticAreTheirOwnMirrorImages)
{
    for (const Rise &rise : {*Rise::symmetric(0.75), Rise::quintic()})
        for (const double x : {0.0, 0.1, 0.37, 0.5})
        {
            const Series<3> left = rise.at<3>(x), right = rise.at<3>(1.0 - x);
            EXPECT_NEAR(left[0] + right[0], 1.0, 1e-15);
            EXPECT_NEAR(left[1], right[1], 1e-14);
            EXPECT_NEAR(left[2], -right[2], 1e-13);
            EXPECT_NEAR(left[3], right[3], 1e-12);
        }
    EXPECT_EQ(Rise::quintic().at<3>(0.0), (Series<3>{0.0, 0.0, 0.0, 60.0}));
}

TEST(TrajectoryRise, RefusesByName)
{
    const double nan = std::nan("");
    EXPECT_EQ(Rise::paper(nan, 0.0, 3.0).failure, TrajectoryFailure::NotFinite);
    EXPECT_EQ(Rise::paper(2.0, -INFINITY, 3.0).failure, TrajectoryFailure::NotFinite);
    EXPECT_EQ(Rise::paper(1.0, 0.0, 3.0).failure, TrajectoryFailure::BadBase);
    EXPECT_EQ(Rise::paper(2.0, 0.0, 0.0).failure, TrajectoryFailure::BadTime);
    EXPECT_EQ(Rise::paper(2.0, 0.0, -1.0).failure, TrajectoryFailure::BadTime);
    // The paper asks for a < T only; for T > 1 that is not enough (its Proposition 1).
    EXPECT_EQ(Rise::paper(5.0, 2.7, 3.0).failure, TrajectoryFailure::Pole);
    const double border = 2.0 * std::sqrt(3.0) - 1.0;
    EXPECT_EQ(Rise::paper(5.0, border, 3.0).failure, TrajectoryFailure::Pole);
    EXPECT_TRUE(Rise::paper(5.0, border - 1e-6, 3.0));
    EXPECT_EQ(Rise::paper(5.0, 0.5, 0.5).failure, TrajectoryFailure::Pole);
    EXPECT_TRUE(Rise::paper(5.0, 0.49, 0.5));
    EXPECT_EQ(Rise::resting(0.0).failure, TrajectoryFailure::BadShape);
    EXPECT_EQ(Rise::symmetric(nan).failure, TrajectoryFailure::NotFinite);
}

TEST(TrajectoryRise, IsFiniteForEveryAdmittedParameter)
{
    std::mt19937_64 random(6);
    const auto draw = [&random](double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    int admitted = 0, poles = 0;
    for (int i = 0; i < 1000000; ++i)
    {
        const double n = 1.0 + std::pow(10.0, draw(-15.0, 300.0 * (i % 2) + 2.0));
        const double duration = std::pow(10.0, i % 3 == 0 ? draw(-6.0, 6.0) : draw(-1.0, 1.0));
        const double a = i % 5 == 0 ? -std::pow(10.0, draw(-3.0, 300.0)) : draw(-3.0, 1.0) * duration;
        const OrFailure<Rise> rise = Rise::paper(n, a, duration);
        poles += rise.failure == TrajectoryFailure::Pole;
        if (!rise)
            continue;
        ++admitted;
        for (const double value : rise->at<3>(std::pow(10.0, draw(-4.0, 0.0))))
            ASSERT_TRUE(std::isfinite(value)) << n << " " << a << " " << duration;
    }
    EXPECT_GT(admitted, 500000);
    EXPECT_GT(poles, 10000);
}

TEST(TrajectoryRise, EnclosuresHoldEveryValueBetween)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const Rise &rise : {*Rise::paper(5.0, 1.95, 3.0), *Rise::resting(0.6), *Rise::symmetric(2.0), Rise::quintic()})
        for (int i = 0; i < 2000; ++i)
        {
            const double from = unit(random), to = std::min(1.0, from + 0.05 * unit(random));
            const Series<4, Enclosure> spans = rise.at<4>(Enclosure(from, to));
            const Series<4> values = rise.at<4>(from + (to - from) * unit(random));
            for (int k = 0; k <= 4; ++k)
            {
                const double rounding = 1e-13 * (1.0 + std::abs(values[k]));
                EXPECT_LE(spans[k].lower, values[k] + rounding);
                EXPECT_GE(spans[k].upper, values[k] - rounding);
            }
        }
}

TEST(TrajectoryRise, ConditionsOfASmoothEndAreWhatTheyClaim)
{
    for (const double n : {1.1, 2.0, 5.0, 7.7})
    {
        const OrFailure<double> a = flatEnd(n, 3.0);
        ASSERT_TRUE(a) << n;
        EXPECT_NEAR(Rise::paper(n, *a, 3.0)->at<1>(1.0)[1], 0.0, 1e-13);
    }
    // From ln n = ln 3 / (sqrt 3 - 1)^2 on, n = 7.77, the slope can vanish beyond a pole only.
    EXPECT_EQ(flatEnd(7.8, 3.0).failure, TrajectoryFailure::Pole);
    EXPECT_EQ(flatEnd(2.0, 1.0).failure, TrajectoryFailure::Pole);
    EXPECT_EQ(flatEnd(1.0, 3.0).failure, TrajectoryFailure::BadBase);
    EXPECT_EQ(flatEnd(2.0, -3.0).failure, TrajectoryFailure::BadTime);
    // The paper's a_v of Fig. 8, to the digits printed.
    EXPECT_NEAR(*flatEnd(1.91, 1.5), 0.8734, 0.5e-4);

    for (const double duration : {1.05, 1.5, 2.6, 3.0, 20.0})
    {
        const OrFailure<EndParameters> end = flatEndTwice(duration);
        ASSERT_TRUE(end) << duration;
        const Series<3> last = Rise::paper(end->n, end->a, duration)->at<3>(1.0);
        const double L = std::log(end->n), scale = std::pow(L * duration, 2);
        EXPECT_NEAR(last[1], 0.0, 1e-12 * scale);
        EXPECT_NEAR(last[2], 0.0, 1e-11 * scale);
        EXPECT_GT(last[3], 0.0);
    }
    EXPECT_NEAR(flatEndTwice(1.5)->n, 54.598150, 1e-6);
    EXPECT_NEAR(flatEndTwice(2.6)->a, 2.6 - std::log(2.6) * 0.8, 1e-14);
    EXPECT_EQ(flatEndTwice(1.0).failure, TrajectoryFailure::BadTime);
    EXPECT_EQ(flatEndTwice(1.0 + 1e-6).failure, TrajectoryFailure::BadTime);
}
}  // namespace
}  // namespace narrows
