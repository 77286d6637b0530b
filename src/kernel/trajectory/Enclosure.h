// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace narrows
{
/// All values that a quantity takes while its argument is somewhere in a span: interval arithmetic, to prove bounds.
///
/// Results hold up to rounding: ends are rounded to nearest, not outward. What is undefined or beyond all bounds
/// somewhere in the span (a quotient by zero) becomes the whole line, never NaN.
struct Enclosure
{
    double lower;  ///< end of the span; may be minus infinity
    double upper;  ///< end of the span; may be infinity

    Enclosure() : Enclosure(0.0) {}
    /// A number is a span of width zero.
    Enclosure(double value) : Enclosure(value, value) {}
    /// From one end to the other; NaN for an end means the whole line.
    Enclosure(double from, double to) : lower(from), upper(to)
    {
        if (std::isnan(from) || std::isnan(to))
        {
            lower = -std::numeric_limits<double>::infinity();
            upper = std::numeric_limits<double>::infinity();
        }
    }

    double magnitude() const { return std::max(-lower, upper); }  ///< the greatest absolute value
    /// Whether the quantity may vanish.
    bool hasZero() const { return lower <= 0.0 && upper >= 0.0; }
};

/// All values that the result takes while the operands take theirs, each for itself.
///@{
inline Enclosure operator-(const Enclosure &a)
{
    return {-a.upper, -a.lower};
}

inline Enclosure operator+(const Enclosure &a, const Enclosure &b)
{
    return {a.lower + b.lower, a.upper + b.upper};
}

inline Enclosure operator-(const Enclosure &a, const Enclosure &b)
{
    return {a.lower - b.upper, a.upper - b.lower};
}

inline Enclosure operator*(const Enclosure &a, const Enclosure &b)
{
    const double p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower, s = a.upper * b.upper;
    if (std::isnan(p + q + r + s))
        return std::numeric_limits<double>::quiet_NaN();
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

inline Enclosure operator/(const Enclosure &a, const Enclosure &b)
{
    if (b.hasZero())
    {
        // A span that only touches zero from above keeps its sign: 1/x up to infinity.
        if (b.lower < 0.0 || b.upper <= 0.0)
            return std::numeric_limits<double>::quiet_NaN();
        return a * Enclosure(1.0 / b.upper, std::numeric_limits<double>::infinity());
    }
    return a * Enclosure(1.0 / b.upper, 1.0 / b.lower);
}

inline Enclosure exp(const Enclosure &a)
{
    return {std::exp(a.lower), std::exp(a.upper)};
}

///@}

/// 1 - e^a without cancellation.
/// \param power e^a
inline double fallFromOne(double a, double power)
{
    // expm1 takes three times as long as exp, and matters near 0 only.
    return a < -0.5 ? 1.0 - power : -std::expm1(a);
}
/// The same of all values.
inline Enclosure fallFromOne(const Enclosure &a, const Enclosure &power)
{
    return {fallFromOne(a.upper, power.upper), fallFromOne(a.lower, power.lower)};
}

/// For code that is written for numbers and enclosures.
///@{
inline double upperEnd(double value)
{
    return value;
}
inline double upperEnd(const Enclosure &value)
{
    return value.upper;
}
///@}
}  // namespace narrows
