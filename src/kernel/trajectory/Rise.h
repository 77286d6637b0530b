// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "kernel/trajectory/Enclosure.h"
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
/// Value and derivatives, from order 0 up.
template <int Order, class Number = double>
using Series = std::array<Number, Order + 1>;

/// A rise from 0 to 1 while its argument x = t / duration goes from 0 to 1: what every trajectory here is made of.
///
/// The paper's function n^t / |n^(t + T/t - 1) - n^a|, divided by its value at T, in a form that neither overflows nor
/// cancels: with L = ln n,
///     w(x) = n^(a - u(x)),  u = T x + 1/x - 1,  g(x) = exp(L (1 - 1/x)) (1 - w(1)) / (1 - w(x)).
/// All its derivatives vanish at x = 0. The "-1" counts in the paper's unit of time, so that T is part of the shape.
class Rise
{
public:
    /// \param n > 1
    /// \param a the paper's modifier; free of poles iff a < 2 sqrt(T) - 1 (T > 1) or a < T (T <= 1)
    /// \param duration T, in [1e-6, 1e6], in the paper's unit of time
    static OrFailure<Rise> paper(double n, double a, double duration);

    /// With a clock of its own, T = 1 + 2/L, and a = T - ln(T)/L: velocity and acceleration vanish at x = 1 too, the
    /// jerk there is L (L+1) (L+2). It ascends and has no pole, whatever L.
    ///     g(x) = 2 / ((L+2) exp(L (1/x - 1)) - L exp((L+2) (1 - x)))
    /// \param shape L in [0.01, 600]
    static OrFailure<Rise> resting(double shape);

    /// Half of resting(shape) and half of its mirror image: point-symmetric about (1/2, 1/2).
    static OrFailure<Rise> symmetric(double shape);

    /// 10 x^3 - 15 x^4 + 6 x^5.
    static Rise quintic();

    /// Value and derivatives by x. Before 0 it is 0, beyond 1 it is 1; at 0 and 1 themselves derivatives are the limits
    /// from within.
    template <int Order, class Number>
    Series<Order, Number> at(const Number &x) const;

private:
    enum class Kind
    {
        Homotopy,
        Symmetric,
        Quintic
    };

    Rise(Kind kind, double logBase, double clock, double logEnd);

    template <int Order, class Number>
    Series<Order, Number> homotopyAt(const Number &x) const;

    Kind kind_;
    double logBase_;  ///< L
    double clock_;    ///< T
    double logEnd_;   ///< L (a - T), the logarithm of w(1)
    double end_;      ///< 1 - w(1)
};

template <int Order, class Number>
Series<Order, Number> Rise::homotopyAt(const Number &x) const
{
    using std::exp;
    constexpr double vanishing = -690.0;  // exp of it is near the least normal number
    if (!(upperEnd(x) > 0.0))
        return Series<Order, Number>{};
    const double L = logBase_;
    const Number inverse = 1.0 / x;
    const Number fall = L * (1.0 - inverse);
    if (!(upperEnd(fall) >= vanishing))
        return Series<Order, Number>{};
    const Number logW = logEnd_ + L * clock_ * (1.0 - x) + fall;
    const Number w = exp(logW), d = fallFromOne(logW, w);
    Series<Order, Number> g;
    g[0] = exp(fall) * (end_ / d);
    if constexpr (Order >= 1)
    {
        // F = g'/g = L p + r m with p = 1/x^2, r = w / (1 - w), m = w'/w = L (p - T); and so r' = m r (1 + r).
        const Number p = inverse * inverse;
        const Number r = w / d, m = L * (p - clock_), s = r / d;
        const Number p1 = -2.0 * inverse * p, p2 = 6.0 * p * p;
        const Number r1 = m * s, m1 = L * p1, m2 = L * p2;
        const Number odd = 1.0 + 2.0 * r;
        const Number r2 = m1 * s + m * r1 * odd;
        const Number F = L * p + r * m;
        const Number F1 = m1 + r1 * m + r * m1;
        const Number F2 = m2 + r2 * m + 2.0 * r1 * m1 + r * m2;
        const Number square = F * F;
        g[1] = g[0] * F;
        if constexpr (Order >= 2)
            g[2] = g[0] * (F1 + square);
        if constexpr (Order >= 3)
            g[3] = g[0] * (F2 + F * (3.0 * F1 + square));
        if constexpr (Order >= 4)
        {
            const Number m3 = -4.0 * inverse * m2;
            const Number r3 = m2 * s + 2.0 * m1 * r1 * odd + m * (r2 * odd + 2.0 * r1 * r1);
            const Number F3 = m3 + r3 * m + 3.0 * r2 * m1 + 3.0 * r1 * m2 + r * m3;
            g[4] = g[0] * (F3 + 4.0 * F * F2 + 3.0 * F1 * F1 + square * (6.0 * F1 + square));
        }
    }
    return g;
}

template <int Order, class Number>
Series<Order, Number> Rise::at(const Number &x) const
{
    static_assert(Order <= 4);
    Series<Order, Number> result{};
    if (upperEnd(x) < 0.0)
        return result;
    if (upperEnd(-x) < -1.0)
    {
        result[0] = 1.0;
        return result;
    }
    if (kind_ == Kind::Homotopy)
        return homotopyAt<Order>(x);
    if (kind_ == Kind::Symmetric)
    {
        const Series<Order, Number> rise = homotopyAt<Order>(x), mirrored = homotopyAt<Order>(Number(1.0 - x));
        for (int k = 0; k <= Order; ++k)
            result[k] = 0.5 * (k % 2 == 0 ? rise[k] - mirrored[k] : rise[k] + mirrored[k]);
        result[0] = result[0] + 0.5;
        return result;
    }
    result[0] = x * x * x * (10.0 + x * (6.0 * x - 15.0));
    if constexpr (Order >= 1)
        result[1] = 30.0 * x * x * (1.0 - x) * (1.0 - x);
    if constexpr (Order >= 2)
        result[2] = 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x);
    if constexpr (Order >= 3)
        result[3] = 60.0 + 360.0 * x * (x - 1.0);
    if constexpr (Order >= 4)
        result[4] = 720.0 * x - 360.0;
    return result;
}
}  // namespace narrows
