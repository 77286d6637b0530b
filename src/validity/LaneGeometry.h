// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

/// Sixteen placements side by side, in single precision: number l of every array belongs to placement l. What is said
/// of them is certain: results are compared with a `room` for all that rounding may have done, and what lies within it
/// is left open.
namespace narrows::lanes
{
constexpr int count = 16;
constexpr double rounding = 1.0 / (1 << 23);  // of two operations in single precision

/// Does the processor treat so many numbers at once? If not, this is slower than one placement after the other.
bool areFast();

struct alignas(64) Points
{
    float x[count], y[count];
};

/// What is known of each placement so far, as the numbers of `Finding` (LinkChecker.h): 0 clear, 1 unsure, 2 touching.
struct alignas(64) Findings
{
    std::int32_t of[count] = {};
};

struct Box
{
    float left, bottom, right, top;
};

/// What squared distances say: beyond `clear` it is clear, below `touching` it touches.
struct Range
{
    float clear, touching;
    float room;  ///< what rounding may do to a distance
};

struct Circle
{
    float x, y;
    Range range;
};

/// A superellipse of exponent 4, in coordinates that make it X^4 + Y^4 <= 1.
struct Quartic
{
    float x, y;                ///< its center
    float inverseX, inverseY;  ///< of the half extents
    float clear;               ///< links are clear that are this far away,
    float touching;            ///< and touch if X^4 + Y^4 is below this somewhere on them
};

struct Edge
{
    float fromX, fromY, toX, toY;
};

struct Link
{
    float length;
    int parent;  ///< -1: the base
};

/// Places links: points[i + 1] = points[parent + 1] + length (cosine, sine) of link i's angle. Each is right to
/// length / 2^22 and the rounding of the sum. \param angles of link i and placement l: angles[i * stride + l]
/// \param points the first is the base \param strange becomes 1 where an angle is not a number or beyond 1e5, for which
/// that does not hold
void placeLinks(const double *angles, std::ptrdiff_t stride, const Link *links, int linkCount, Points *points,
                Findings &strange);

/// The boxes that one link meets, as bits.
struct alignas(64) Meetings
{
    std::uint32_t of[count];  ///< in each placement
    std::uint32_t any;        ///< in any
};

/// Which boxes does the box around each link meet? \param points, links as above \pre boxCount <= 32
void findMeetings(const Points *points, const Link *links, int linkCount, const Box *boxes, int boxCount,
                  Meetings *meetings);

/// Bit l: does the box around ab meet that around cd, made `room` larger, in placement l?
std::uint32_t findMeetings(const Points &a, const Points &b, const Points &c, const Points &d, float room);

/// What can be said of the segments ab and one obstacle: `found` becomes the worse of it and what it was.
void examine(const Points &a, const Points &b, const Circle &circle, Findings &found);
void examine(const Points &a, const Points &b, const Quartic &shape, Findings &found);
/// A polygon. \param range of distances between segments and edges
void examine(const Points &a, const Points &b, const Edge *edges, int edgeCount, const Range &range, Findings &found);
/// The same of two links.
void examine(const Points &a, const Points &b, const Points &c, const Points &d, const Range &range, Findings &found);
}  // namespace narrows::lanes
