// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "spaces/TipGoalRegion.h"

namespace narrows
{
/// Points that a tip has to reach one after the other. As OMPL sees it, a state is a goal when its tip is at the last
/// point, and samples are drawn there; that the points before were reached in order is for those to see to who know
/// path(): planners that follow tip paths, LegByLeg, the verifier.
class TipPathGoal : public SpatialTipGoalRegion
{
public:
    /// \pre the state space of `si` is a SpatialArmStateSpace and `path.link` one of its arm's links.
    /// \throws std::invalid_argument if the path has no points
    TipPathGoal(const ob::SpaceInformationPtr &si, const SpatialTipPath &path);

    /// Which tip shall be where, one place after the other.
    const SpatialTipPath &path() const { return path_; }

private:
    SpatialTipPath path_;
};

/// The goal that consists of one of the path's points.
SpatialTipGoal tipGoalAt(const SpatialTipPath &path, std::size_t index);

/// What a goal asks of a tip: the path of a TipPathGoal, a path of one point for a SpatialTipGoalRegion, nothing for
/// any other goal.
std::optional<SpatialTipPath> tipPathOf(const ob::Goal &goal);
}  // namespace narrows
