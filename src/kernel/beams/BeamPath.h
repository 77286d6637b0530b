// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kernel/beams/CriticalRegion.h"

namespace narrows
{
/// Why there is no path by beams.
enum class BeamFailure
{
    None,
    MiddleTooShort,  ///< no two different points, or one that is not finite
    MiddleBlocked,   ///< a station of the middle path has less room than the links need
    NotRepaired,     ///< the path between two stations still meets an obstacle after all repairs
};

/// "middle_blocked" and the like.
std::string toText(BeamFailure failure);

/// How the path is made of beams.
struct BeamOptions
{
    BeamFanOptions fan;  ///< how beams are cast
    /// By default standardRegions(), a passage being as wide as the typical clearance and the link on both sides.
    std::optional<CriticalRegionOptions> regions;
    /// >= 0, half-width of the paper's windowing of the middle path, a length (about a quarter of a passage's width); 0
    /// leaves it as it is.
    double window = 0.0;
    int passes = 3;         ///< of the window, >= 0
    double switchAt = 0.5;  ///< in [0, 1]: where between two regions the path changes sides (the paper: in the middle)
    /// > 0, in link lengths: how far behind a region the path changes sides if the next one is more than a link away
    /// (the paper: "earlier").
    double early = 0.5;
    double ramp = 0.0;   ///< >= 0, a length: ours, over which it changes sides; the paper jumps
    bool repair = true;  ///< ours: shorten beams until the path meets no obstacle
};

/// The path that the joints follow (Minnetoglu and Conkur 2022, Sections 4.2, 4.3, 4.6 and 4.7): it goes through the
/// far ends of the beams opposite to the critical region in charge, so that links swing wide of its inner corner.
template <int D>
struct BeamPath
{
    BeamFailure failure = BeamFailure::None;  ///< none: the path is whole
    PointPath<D> path;                        ///< begins and ends with the middle path's ends
    std::vector<CriticalRegion> regions;      ///< none: the path is the middle path
    int beams = 0;                            ///< how many were cast
    int repairs = 0;                          ///< how often a beam was shortened
};

/// The text of the paper as far as it goes; every gap that was filled is named in docs/tight.md. That a path was found
/// does not say that a chain can follow it: that is the certificate's business. \param distance of points from the
/// obstacles \throws std::invalid_argument if an option is out of its range
template <int D>
BeamPath<D> beamPath(const PointPath<D> &middle, const PointDistance<D> &distance, const BeamOptions &options);

extern template BeamPath<2> beamPath(const PointPath<2> &, const PointDistance<2> &, const BeamOptions &);
extern template BeamPath<3> beamPath(const PointPath<3> &, const PointDistance<3> &, const BeamOptions &);
}  // namespace narrows
