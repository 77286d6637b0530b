// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>

#include "kernel/fields/PathWindow.h"

namespace narrows
{
/// Distance of a point from all obstacles, not positive inside; a lower bound will do. Between two points it changes by
/// no more than they are apart.
template <int D>
using PointDistance = std::function<double(const Eigen::Matrix<double, D, 1> &)>;

/// Beams that hit nothing end after so many link lengths.
constexpr double openBeamLinks = 4.0;

/// How densely and how far beams are cast.
struct BeamFanOptions
{
    double linkLength = 0.0;  ///< > 0
    double radius = 0.0;      ///< >= 0, half-width of the links
    double spacing = 0.0;     ///< > 0, between neighbouring stations; a twentieth to a tenth of a passage's width
    int couples = 2;          ///< 1 to 4; in the plane there is one, left and right
    double longest = std::numeric_limits<double>::infinity();  ///< > 0, where beams end that have met nothing
    /// Ours: in open space before the entrance (and behind the exit) beams are no longer than beams in the middle of a
    /// passage: where a station has more than `openSpace` times the median clearance, the median.
    double openSpace = 2.0;
};

/// The beams of one couple: two from every station, in opposite directions.
template <int D>
struct BeamCouple
{
    PointPath<D> directions;         ///< unit vectors, at right angles to the path
    std::vector<double> lengths[2];  ///< along the direction, against it

    /// From the station to where the beam ends.
    Eigen::Matrix<double, D, 1> offset(int side, int station) const
    {
        const double signedLength = side == 0 ? lengths[0][station] : -lengths[1][station];
        return signedLength * directions[station];
    }
};

/// A middle path and the beams from its points at right angles to it (Minnetoglu and Conkur 2022, Sections 4.1
/// and 4.5).
///
/// In the plane there is one couple, to the left (side 0) and to the right. In space couple m of C lies at the angle
/// pi m / C in a frame that is carried along the path with the least rotation (double reflection: Wang et al., ACM
/// Transactions on Graphics 27 (2008) 2); the paper leaves the frame open. It begins with the world's z axis, or its x
/// axis where the path does not start across z.
template <int D>
struct BeamFan
{
    PointPath<D> stations;               ///< on the middle path, evenly
    PointPath<D> tangents;               ///< unit vectors
    std::vector<double> clearance;       ///< of the stations, less the radius of the links
    std::vector<BeamCouple<D>> couples;  ///< one in the plane, one to four in space
    double spacing = 0.0;                ///< between neighbouring stations along the path
    double typicalClearance = 0.0;       ///< the median of `clearance`

    int count() const { return static_cast<int>(stations.size()); }  ///< of the stations
    /// Where a beam ends.
    Eigen::Matrix<double, D, 1> end(int couple, int side, int station) const
    {
        return stations[station] + couples[couple].offset(side, station);
    }
};

/// Beams end where a ball of the links' radius meets an obstacle (the paper: at the obstacle's border), by sphere
/// tracing, within a thousandth of the spacing before it. \param middle at least two different points; stations are
/// taken at equal shares of its length \pre the options are in their ranges
template <int D>
BeamFan<D> castBeams(const PointPath<D> &middle, const PointDistance<D> &distance, const BeamFanOptions &options);

extern template BeamFan<2> castBeams(const PointPath<2> &, const PointDistance<2> &, const BeamFanOptions &);
extern template BeamFan<3> castBeams(const PointPath<3> &, const PointDistance<3> &, const BeamFanOptions &);
}  // namespace narrows
