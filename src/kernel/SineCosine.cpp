// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SineCosine.h"

#include <cmath>

#include "kernel/Multiversion.h"

namespace narrows
{
namespace
{
/// Nearest integer of |x| < 2^51: adding 1.5 * 2^52 leaves no room for a fraction.
inline double nearestInteger(double x)
{
    constexpr double shift = 6755399441055744.0;
    return (x + shift) - shift;
}

/// Taylor's series on [-pi/4, pi/4], where the first term left out is below 1e-16; by pairs, which the processor works
/// out side by side.
inline double sineSeries(double x, double square)
{
    const double fourth = square * square;
    const double low = (-1.0 / 6.0 + (1.0 / 120.0) * square) + fourth * (-1.0 / 5040.0 + (1.0 / 362880.0) * square);
    const double high = (-1.0 / 39916800.0 + (1.0 / 6227020800.0) * square) - (1.0 / 1307674368000.0) * fourth;
    return x + x * square * (low + fourth * fourth * high);
}

inline double cosineSeries(double square)
{
    const double fourth = square * square;
    const double low = (1.0 / 24.0 - (1.0 / 720.0) * square) + fourth * (1.0 / 40320.0 - (1.0 / 3628800.0) * square);
    const double high = (1.0 / 479001600.0 - (1.0 / 87178291200.0) * square) + (1.0 / 20922789888000.0) * fourth;
    return (1.0 - 0.5 * square) + fourth * (low + fourth * fourth * high);
}

constexpr int step = 8;  // numbers in the longest vectors

/// Without branches, so that it becomes vector instructions. False if an angle was too large for that.
NARROWS_MULTIVERSION bool evaluateInVectors(SineCosineBlock &block, int steps)
{
    // pi / 2 in two parts, the first of 33 bits, so that its product with `quarters` is exact.
    constexpr double first = 1.57079632673412561417, second = 6.07710050650619224932e-11;
    int tooLarge = 0;
    for (int i = 0; i < steps * step; ++i)
    {
        const double angle = block.angles[i];
        tooLarge |= std::abs(angle) <= 1e5 ? 0 : 1;
        const double quarters = nearestInteger(angle * 0.63661977236758134308);
        const double rest = (angle - quarters * first) - quarters * second;
        const double square = rest * rest;
        const double sine = sineSeries(rest, square), cosine = cosineSeries(square);
        const double turn = quarters - 4.0 * nearestInteger(0.25 * quarters);  // -2 ... 2, -2 and 2 being the same
        const bool odd = turn * turn == 1.0;
        const double signOfCosine = turn > 0.0 || turn == -2.0 ? -1.0 : 1.0;
        const double signOfSine = turn < 0.0 || turn == 2.0 ? -1.0 : 1.0;
        block.cosines[i] = signOfCosine * (odd ? sine : cosine);
        block.sines[i] = signOfSine * (odd ? cosine : sine);
    }
    return tooLarge == 0;
}
}  // namespace

void SineCosineBlock::evaluate(int count)
{
    const int steps = (count + step - 1) / step;
    for (int i = count; i < steps * step; ++i)
        angles[i] = 0.0;
    if (evaluateInVectors(*this, steps))
        return;
    for (int i = 0; i < count; ++i)
    {
        cosines[i] = std::cos(angles[i]);
        sines[i] = std::sin(angles[i]);
    }
}
}  // namespace narrows
