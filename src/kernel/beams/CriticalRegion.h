// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/beams/BeamFan.h"

namespace narrows
{
/// The page of the paper that says which beams are critical is lost; this criterion is ours. On the inner side of a
/// bend the far ends of the beams crowd, on the outer side they spread: a station is critical to one side if its far
/// ends move by less than `slow` times the way along the path, and by less than `ratio` times what the other side's
/// move by.
struct CriticalRegionOptions
{
    double slow = 0.95;     ///< in (0, 1]
    double ratio = 0.6;     ///< in (0, 1]
    double gap = 0.0;       ///< >= 0, a length: critical stations of one side closer than this are one region
    double turning = 0.26;  ///< >= 0, radians: the path must turn more than this over a region's critical stations
};

/// What was tried on the scenes of docs/tight.md gave: 15 degrees in the plane; in space 35 degrees and a gap of a
/// passage's width. \param width of a passage
template <int D>
CriticalRegionOptions standardRegions(double width)
{
    constexpr double degree = M_PI / 180.0;
    CriticalRegionOptions options;
    options.gap = D == 2 ? 0.0 : width;
    options.turning = (D == 2 ? 15.0 : 35.0) * degree;
    return options;
}

/// Where a link must swing wide, around an inner corner to one side of the path.
struct CriticalRegion
{
    int couple = 0;        ///< of beams: index in BeamFan::couples
    int side = 0;          ///< of the couple, where the inner corner is: 0 along its direction, 1 against it
    int first = 0;         ///< station
    int last = 0;          ///< station, >= first
    double turning = 0.0;  ///< radians, of the path over its critical stations
    double weight = 0.0;   ///< turning times how much the far ends crowd: which of two couples sees the corner better
};

/// The regions of all couples along the path. Of two that overlap by more than half of the shorter one, the one with
/// more weight remains.
template <int D>
std::vector<CriticalRegion> findCriticalRegions(const BeamFan<D> &fan, const CriticalRegionOptions &options);

extern template std::vector<CriticalRegion> findCriticalRegions(const BeamFan<2> &, const CriticalRegionOptions &);
extern template std::vector<CriticalRegion> findCriticalRegions(const BeamFan<3> &, const CriticalRegionOptions &);
}  // namespace narrows
