// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

#include "validity/LaneGeometry.h"

/// Arithmetic of LaneGeometry.cpp, which alone includes this.
namespace narrows::lanes
{
// One number per placement, which the compiler makes as many vector instructions of as it takes. Their alignment, and
// how they are passed to functions that are not inline, change with the instructions: none may leave that file.
using Floats [[gnu::vector_size(4 * count)]] = float;
using Integers [[gnu::vector_size(4 * count)]] = std::int32_t;
using Doubles [[gnu::vector_size(8 * count)]] = double;

#define NARROWS_INLINE [[gnu::always_inline]] inline

template <class Vector, class Number>
NARROWS_INLINE Vector load(const Number *numbers)
{
    Vector vector;
    std::memcpy(&vector, numbers, sizeof vector);
    return vector;
}

/// Points as vectors.
struct Places
{
    [[gnu::always_inline]] Places(const Points &p) : x(load<Floats>(p.x)), y(load<Floats>(p.y)) {}
    [[gnu::always_inline]] Places(const Floats &atX, const Floats &atY) : x(atX), y(atY) {}

    Floats x, y;
};

NARROWS_INLINE Floats least(const Floats &a, const Floats &b)
{
    return a < b ? a : b;
}

NARROWS_INLINE Floats greatest(const Floats &a, const Floats &b)
{
    return a > b ? a : b;
}

/// The same number for all placements.
NARROWS_INLINE Floats all(float a)
{
    return Floats{} + a;
}

NARROWS_INLINE Floats size(const Floats &a)
{
    return a < 0.0f ? -a : a;
}

NARROWS_INLINE Floats between01(const Floats &t)
{
    return least(greatest(t, Floats{}), all(1.0f));
}

NARROWS_INLINE Integers worse(const Integers &a, const Integers &b)
{
    return a > b ? a : b;
}

NARROWS_INLINE Integers findings(const Floats &square, const Range &range)
{
    return square > range.clear ? Integers{} : square < range.touching ? Integers{} + 2 : Integers{} + 1;
}

NARROWS_INLINE void worsen(Findings &found, const Integers &by)
{
    const Integers worst = worse(load<Integers>(found.of), by);
    std::memcpy(found.of, &worst, sizeof worst);
}

/// The bits that any number has.
NARROWS_INLINE std::uint32_t anyOf(const Integers &bits)
{
    std::uint64_t words[count / 2], any = 0;
    std::memcpy(words, &bits, sizeof words);
    for (const std::uint64_t word : words)
        any |= word;
    return static_cast<std::uint32_t>(any | any >> 32);
}

constexpr Integers lane = {1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                           1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
}  // namespace narrows::lanes
