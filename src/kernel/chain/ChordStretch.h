// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/chain/LeaderPath.h"

namespace narrows
{
/// What is known of the chords P(g(s))P(s) over a stretch of s within one segment, from the chord in its middle.
template <int D>
struct ChordStretch
{
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space

    double begin;         ///< of the stretch, in s
    double end;           ///< of the stretch, in s
    Point front;          ///< P(s) in the middle
    Point rear;           ///< P(g(s)) in the middle
    double place;         ///< g(s) in the middle
    bool continuous;      ///< g is certainly continuous over the stretch
    double frontMoves;    ///< how far the chords' ends get from there, at most
    double rearMoves;     ///< the same of the rear ends
    double angle;         ///< bend of the joint at the rear, in the middle
    double angleMoves;    ///< how far it gets from there, at most
    double secondAtMost;  ///< g(g(s)) over the stretch
    double rate;          ///< |g'(s)| in the middle

    double middle() const { return 0.5 * (begin + end); }  ///< of the stretch, in s
    double half() const { return 0.5 * (end - begin); }    ///< its length
    /// How far any point of the chord gets from where it is in the middle, at most.
    double moves() const { return std::max(frontMoves, rearMoves); }
};

/// \pre begin < end, both on one segment of the path (0 <= begin), and the stretch shorter than half a link
template <int D>
ChordStretch<D> chordStretch(const LeaderPath<D> &path, double linkLength, double begin, double end);

extern template ChordStretch<2> chordStretch(const LeaderPath<2> &, double, double, double);
extern template ChordStretch<3> chordStretch(const LeaderPath<3> &, double, double, double);
}  // namespace narrows
