// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/fields/PathWindow.h"

namespace narrows
{
/// The way of a chain's tip, which all its joints follow (tight maneuvering: "follow the leader"), by arc length s.
///
/// A polyline from s = 0, the entrance, to s = length(). Before it, for all s < 0, lies the entrance line, straight
/// and without end, on which the chain waits. With the tip at s, the joint before it is at follower(s, L), the one
/// before that at follower(follower(s, L), L), and so on. Immutable.
template <int D>
class LeaderPath
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space

    /// \param nodes at least two; neighbours that coincide are taken as one
    /// \param entrance direction in which the entrance line leads to the first node, not zero
    /// \throws std::invalid_argument if these are not met or a number is not finite
    LeaderPath(const PointPath<D> &nodes, const Point &entrance);

    double length() const { return arcs_.back(); }        ///< s of the last node
    const PointPath<D> &nodes() const { return nodes_; }  ///< of neighbours that coincide only one
    /// Of every node: its s. Begins with 0, rises strictly.
    const std::vector<double> &arcs() const { return arcs_; }
    const Point &entrance() const { return entrance_; }  ///< unit vector along the entrance line

    /// \param s at most length() (beyond it: the last node)
    Point at(double s) const;
    /// Unit vector along the path just before s.
    Point directionBefore(double s) const;

    /// g(s): the greatest t < s with |P(s) - P(t)| = distance. Exact on the segments of the polyline.
    /// \param distance > 0
    double follower(double s, double distance) const { return follower(s, at(s), distance); }
    /// The same for any point x in place of P(s): the greatest t <= s with |x - P(t)| >= distance.
    double follower(double s, const Point &x, double distance) const;

    /// Index i of the segment nodes()[i] to nodes()[i + 1] that s, in (0, length()], lies in or ends.
    int segmentBefore(double s) const;

private:
    double onSegment(int segment, const Point &x, double distance) const;

    PointPath<D> nodes_;
    std::vector<double> arcs_;
    Point entrance_;
};

/// Places of the joints of a chain with its tip at s: result[0] = s, result[i + 1] = g(result[i]).
/// \param links how many links of the given length, >= 0
template <int D>
std::vector<double> jointPlaces(const LeaderPath<D> &path, double s, double linkLength, int links);

extern template class LeaderPath<2>;
extern template class LeaderPath<3>;
extern template std::vector<double> jointPlaces(const LeaderPath<2> &, double, double, int);
extern template std::vector<double> jointPlaces(const LeaderPath<3> &, double, double, int);
}  // namespace narrows
