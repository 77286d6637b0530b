// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "planners/JointChart.h"

namespace narrows
{
/// What a path should be like.
struct BandWish
{
    double clearance = 0.0;  ///< length units that the arm should keep from everything; 0: only short
    double aversion = 10.0;  ///< how many times as long a way counts where the clearance is 0; what is lacking counts
                             ///< in proportion
    double spacing = 0.2;    ///< longest motion between two of the band's states, in the chart; > 0
    int sweeps = 60;         ///< over all states, at most
};

/// What came of it.
struct BandReport
{
    double before = 0.0;  ///< length in the chart, with the aversion
    double after = 0.0;   ///< the same of the result, <= before
    int moves = 0;        ///< states that went somewhere better, over all sweeps
    int sweeps = 0;       ///< over all states
};

/// Bends a free path towards one that is shorter and, where that is wished, further from obstacles: an elastic band (S.
/// Quinlan and O. Khatib, Elastic bands, ICRA 1993). Its states go, one after the other, towards the middle between
/// their neighbours and away from what is near, if the path gets better by that and the motion validator accepts both
/// motions next to them: whatever the validator proves of the path, it has proven of the result. Both ends stay what
/// they are. Deterministic. Ends when a sweep gains less than a ten thousandth, or when told to; the path is free at
/// any time. \pre the space is that of the chart, all motions of the path are free
BandReport tightenBand(const ob::SpaceInformationPtr &si, const JointChart &chart, og::PathGeometric &path,
                       const BandWish &wish, const ob::PlannerTerminationCondition &ptc);
}  // namespace narrows
