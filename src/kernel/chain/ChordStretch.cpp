// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChordStretch.h"

namespace narrows
{
namespace
{
/// Calls visit(t, direction) for the upper end of every straight piece of the path between two places, the later first,
/// and at last for the lower place.
template <int D, class Visit>
void visitPieces(const LeaderPath<D> &path, double lower, double upper, const Visit &visit)
{
    for (double t = upper; t > lower;)
    {
        visit(t, path.directionBefore(t));
        t = t <= 0.0 ? lower : std::max(path.arcs()[path.segmentBefore(t)], lower);
    }
    visit(lower, path.directionBefore(lower));
}

/// Where the joint behind a place may be while that place is anywhere within `moves` of `from`.
struct Reach
{
    double lower;
    double upper;
};

template <int D>
Reach followerReach(const LeaderPath<D> &path, double s, const Eigen::Matrix<double, D, 1> &from, double length,
                    double moves)
{
    return {path.follower(s, from, length + moves), path.follower(s, from, length - moves)};
}

template <int D>
double spread(const LeaderPath<D> &path, const Reach &reach, const Eigen::Matrix<double, D, 1> &from)
{
    double most = 0.0;
    visitPieces<D>(path, reach.lower, reach.upper,
                   [&](double t, const auto &) { most = std::max(most, (path.at(t) - from).norm()); });
    return most;
}

/// Angle between two vectors of the same length that differ by `difference`.
double angleOf(double difference, double length)
{
    return 2.0 * std::asin(std::min(0.5 * difference / length, 1.0));
}
}  // namespace

template <int D>
ChordStretch<D> chordStretch(const LeaderPath<D> &path, double linkLength, double begin, double end)
{
    ChordStretch<D> result{};
    result.begin = begin;
    result.end = end;
    const double s = result.middle(), moves = result.half();
    result.front = path.at(s);
    result.place = path.follower(s, result.front, linkLength);
    result.rear = path.at(result.place);
    result.frontMoves = moves;

    // The distance from all places of the front end has to fall strictly towards the later ones.
    const Reach reach = followerReach<D>(path, s, result.front, linkLength, moves);
    result.continuous = true;
    visitPieces<D>(path, reach.lower, reach.upper,
                   [&](double t, const auto &along)
                   { result.continuous = result.continuous && (result.front - path.at(t)).dot(along) > moves; });
    result.rearMoves = spread<D>(path, reach, result.rear);

    const double second = path.follower(result.place, result.rear, linkLength);
    const auto last = path.at(second);
    const double rearMoves = std::min(result.rearMoves, linkLength);
    const Reach behind = followerReach<D>(path, result.place, result.rear, linkLength, rearMoves);
    result.secondAtMost = behind.upper;
    result.angle = angleOf((result.front + last - 2.0 * result.rear).norm(), linkLength);
    result.angleMoves = angleOf(moves + result.rearMoves, linkLength) +
                        angleOf(result.rearMoves + spread<D>(path, behind, last), linkLength);

    const auto chord = result.front - result.rear;
    result.rate = std::abs(chord.dot(path.directionBefore(s))) / chord.dot(path.directionBefore(result.place));
    return result;
}

template ChordStretch<2> chordStretch(const LeaderPath<2> &, double, double, double);
template ChordStretch<3> chordStretch(const LeaderPath<3> &, double, double, double);
}  // namespace narrows
