// SPDX-License-Identifier: BSD-3-Clause
#include "validity/LaneGeometry.h"

#include "kernel/Multiversion.h"
#include "validity/LaneVectors.h"

// Verdicts do not depend on how anything here is rounded, so that this file may be compiled with contraction.
namespace narrows::lanes
{
namespace
{
struct Segments
{
    Floats x, y, alongX, alongY, inverseSquare;
};

NARROWS_INLINE Segments segments(const Places &a, const Places &b)
{
    const Floats alongX = b.x - a.x, alongY = b.y - a.y;
    return {a.x, a.y, alongX, alongY, 1.0f / greatest(alongX * alongX + alongY * alongY, all(1e-30f))};
}

NARROWS_INLINE Floats squaredDistance(const Segments &s, const Floats &atX, const Floats &atY)
{
    const Floats x = atX - s.x, y = atY - s.y;
    const Floats t = between01((x * s.alongX + y * s.alongY) * s.inverseSquare);
    const Floats restX = x - t * s.alongX, restY = y - t * s.alongY;
    return restX * restX + restY * restY;
}

/// Of segments that do not cross.
NARROWS_INLINE Floats squaredDistance(const Segments &s, const Segments &t)
{
    const Floats ends = least(squaredDistance(s, t.x, t.y), squaredDistance(s, t.x + t.alongX, t.y + t.alongY));
    const Floats others = least(squaredDistance(t, s.x, s.y), squaredDistance(t, s.x + s.alongX, s.y + s.alongY));
    return least(ends, others);
}

/// Times the length of s: how far is a point to the left of it?
NARROWS_INLINE Floats left(const Segments &s, const Floats &x, const Floats &y)
{
    return s.alongX * (y - s.y) - s.alongY * (x - s.x);
}

/// Do both ends of t keep to one side of the line of s (apart > 0), or to either (opposite > 0), by more than `room`?
struct Sides
{
    Floats apart, opposite;
};

NARROWS_INLINE Sides sides(const Segments &s, const Segments &t, float room)
{
    const Floats from = left(s, t.x, t.y), to = left(s, t.x + t.alongX, t.y + t.alongY);
    const Floats low = least(from, to), high = greatest(from, to), rounding = room * (size(s.alongX) + size(s.alongY));
    return {greatest(low, -high) - rounding, least(high, -low) - rounding};
}

NARROWS_INLINE Integers findings(const Segments &s, const Segments &t, const Range &range)
{
    const Floats square = squaredDistance(s, t);
    const Sides one = sides(s, t, range.room), other = sides(t, s, range.room);
    const Floats clear = least(square - range.clear, greatest(one.apart, other.apart));
    const Floats touching = greatest(range.touching - square, least(one.opposite, other.opposite));
    return clear > 0.0f ? Integers{} : touching > 0.0f ? Integers{} + 2 : Integers{} + 1;
}

// Taylor's series on [-pi/4, pi/4]; the first terms left out are below 3e-9 and 3e-8.
NARROWS_INLINE Floats sineSeries(const Floats &x, const Floats &square)
{
    return x + x * square * (-1.0f / 6 + square * (1.0f / 120 + square * (-1.0f / 5040 + square * (1.0f / 362880))));
}

NARROWS_INLINE Floats cosineSeries(const Floats &square)
{
    return 1.0f + square * (-0.5f + square * (1.0f / 24 + square * (-1.0f / 720 + square * (1.0f / 40320))));
}

/// Nearest integers of |x| < 2^51.
NARROWS_INLINE Doubles nearestIntegers(const Doubles &x)
{
    constexpr double shift = 6755399441055744.0;
    return (x + shift) - shift;
}
}  // namespace

bool areFast()
{
    static const bool fast = NARROWS_HAS_LONG_VECTORS;
    return fast;
}

NARROWS_MULTIVERSION void placeLinks(const double *angles, std::ptrdiff_t stride, const Link *links, int linkCount,
                                     Points *points, Findings &strange)
{
    for (int i = 0; i < linkCount; ++i, angles += stride)
    {
        const auto angle = load<Doubles>(angles);
        worsen(strange, size(__builtin_convertvector(angle, Floats)) <= 1e5f ? Integers{} : Integers{} + 1);
        const Doubles quarters = nearestIntegers(angle * 0.63661977236758134308);
        const Floats rest = __builtin_convertvector(angle - quarters * 1.57079632679489661923, Floats);
        const Integers quarter = __builtin_convertvector(quarters, Integers);
        const Floats square = rest * rest, sine = sineSeries(rest, square), cosine = cosineSeries(square);
        const Integers odd = (quarter & 1) != 0;
        const Floats across = odd ? sine : cosine, up = odd ? cosine : sine;
        const Points &base = points[links[i].parent + 1];
        const Floats x = load<Floats>(base.x) + links[i].length * (((quarter + 1) & 2) != 0 ? -across : across);
        const Floats y = load<Floats>(base.y) + links[i].length * ((quarter & 2) != 0 ? -up : up);
        std::memcpy(points[i + 1].x, &x, sizeof x);
        std::memcpy(points[i + 1].y, &y, sizeof y);
    }
}

NARROWS_MULTIVERSION void findMeetings(const Points *points, const Link *links, int linkCount, const Box *boxes,
                                       int boxCount, Meetings *meetings)
{
    for (int i = 0; i < linkCount; ++i)
    {
        const Places a(points[links[i].parent + 1]), b(points[i + 1]);
        const Floats left = least(a.x, b.x), right = greatest(a.x, b.x);
        const Floats bottom = least(a.y, b.y), top = greatest(a.y, b.y);
        Integers met = {};
        for (int k = 0; k < boxCount; ++k)
        {
            const Box &box = boxes[k];
            const Floats apart =
                greatest(greatest(left - box.right, box.left - right), greatest(bottom - box.top, box.bottom - top));
            met |= apart > 0.0f ? Integers{} : Integers{} + static_cast<std::int32_t>(1u << k);
        }
        std::memcpy(meetings[i].of, &met, sizeof met);
        meetings[i].any = anyOf(met);
    }
}

NARROWS_MULTIVERSION std::uint32_t findMeetings(const Points &from, const Points &to, const Points &otherFrom,
                                                const Points &otherTo, float room)
{
    const Places a(from), b(to), c(otherFrom), d(otherTo);
    const Floats apartX = greatest(least(a.x, b.x) - greatest(c.x, d.x), least(c.x, d.x) - greatest(a.x, b.x));
    const Floats apartY = greatest(least(a.y, b.y) - greatest(c.y, d.y), least(c.y, d.y) - greatest(a.y, b.y));
    return anyOf(greatest(apartX, apartY) > room ? Integers{} : lane);
}

NARROWS_MULTIVERSION void examine(const Points &from, const Points &to, const Circle &circle, Findings &found)
{
    const Places a(from), b(to);
    const Floats square = squaredDistance(segments(a, b), all(circle.x), all(circle.y));
    worsen(found, findings(square, circle.range));
}

/// The tangent parallel to the gauge's level line through the link's deepest point separates the two, if anything does.
NARROWS_MULTIVERSION void examine(const Points &from, const Points &to, const Quartic &shape, Findings &found)
{
    const Places a(from), b(to);
    const Floats fromX = (a.x - shape.x) * shape.inverseX, fromY = (a.y - shape.y) * shape.inverseY;
    const Floats toX = (b.x - shape.x) * shape.inverseX, toY = (b.y - shape.y) * shape.inverseY;
    const Floats alongX = toX - fromX, alongY = toY - fromY;
    const Floats squareX = alongX * alongX, squareY = alongY * alongY, tiny = all(1e-30f);
    Floats t = between01(-(fromX * alongX + fromY * alongY) / greatest(squareX + squareY, tiny));
    Floats x = fromX + t * alongX, y = fromY + t * alongY;
    for (int step = 0; step < 2; ++step)  // Newton's
    {
        const Floats bend = 3.0f * (x * x * squareX + y * y * squareY);
        t = between01(t - (x * x * x * alongX + y * y * y * alongY) / greatest(bend, tiny));
        x = fromX + t * alongX;
        y = fromY + t * alongY;
    }
    const Floats cubeX = x * x * x, cubeY = y * y * y, power = cubeX * x + cubeY * y;
    const Floats normalX = size(cubeX) * shape.inverseX, normalY = size(cubeY) * shape.inverseY;
    // At least the normal's length.
    const Floats length = greatest(normalX, normalY) + 0.4143f * least(normalX, normalY);
    const Floats height = least(cubeX * fromX + cubeY * fromY, cubeX * toX + cubeY * toY) - length * shape.clear;
    // Is it more than power^(3/4), the shape's own?
    const Floats outwards = greatest(height, Floats{}), square = outwards * outwards;
    const Integers otherwise = power < shape.touching ? Integers{} + 2 : Integers{} + 1;
    worsen(found, square * square > 1.00001f * (power * power * power) ? Integers{} : otherwise);
}

NARROWS_MULTIVERSION void examine(const Points &from, const Points &to, const Edge *edges, int edgeCount,
                                  const Range &range, Findings &found)
{
    const Places a(from), b(to);
    const Segments links = segments(a, b);
    Integers worst = {};
    Floats outside = all(1.0f);  // -1 inside
    for (int k = 0; k < edgeCount; ++k)
    {
        const auto &[fromX, fromY, toX, toY] = edges[k];
        const Segments edge = segments(Places(all(fromX), all(fromY)), Places(all(toX), all(toY)));
        worst = worse(worst, findings(links, edge, range));
        // Crossed by the ray from the link's base to the right?
        const Floats start = fromY > a.y ? all(1.0f) : all(-1.0f), end = toY > a.y ? all(1.0f) : all(-1.0f);
        const Floats ahead = (end - start) * left(edge, a.x, a.y) > 0.0f ? all(1.0f) : Floats{};
        outside *= 1.0f - (1.0f - start * end) * ahead;
    }
    // Which side of an edge the base is on is certain unless it is near the edge, which is not clear.
    const Integers within = 2 - worst * (2 - worst);
    worsen(found, outside < 0.0f ? within : worst);
}

NARROWS_MULTIVERSION void examine(const Points &from, const Points &to, const Points &otherFrom, const Points &otherTo,
                                  const Range &range, Findings &found)
{
    const Places a(from), b(to), c(otherFrom), d(otherTo);
    worsen(found, findings(segments(a, b), segments(c, d), range));
}
}  // namespace narrows::lanes
