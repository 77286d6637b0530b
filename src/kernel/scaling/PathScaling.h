// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/scaling/ScalingProblem.h"

namespace narrows
{
/// How the joint centres are found that belong to a tip.
enum class ScalingMode
{
    PaperNearest,   ///< step 5 as printed: the nearest of the four points on the auxiliary lines
    PaperVertical,  ///< the nearest on the line along z if there is one; this reproduces the paper's figures
    Branch,         ///< all points on the auxiliary lines, the choices that fit together over the whole path
    Taut            ///< along the taut string around the danger regions; each of its bends is a new zoom centre
};

/// How poses are chosen, and what they must keep.
struct ScalingOptions
{
    ScalingMode mode = ScalingMode::Taut;  ///< the rule by which joint centres are chosen
    double margin = 0.0;                   ///< what is closer to an obstacle is its danger region; at least the radius
    std::vector<double> margins;           ///< per section, where they differ; empty: all as above
    double maxJump = 0.0;   ///< largest way of a joint in the section plane from one tip to the next, > 0
    int easing = 40;        ///< rounds in which poses that break a rule are eased (Taut)
    SectionChain wrapping;  ///< joints of a pose whose way around the obstacles is to be kept (Taut); empty: none
    /// Per section: tips may be in its danger region, as they are beyond it along the slide (Taut); empty: none.
    std::vector<bool> behind;
    /// Tips at the beginning that cannot be had are left out (not by Branch, nor at crossbars).
    bool lateStart = false;
    std::function<bool()> interrupt;  ///< asked now and then, if set; true ends the work

    /// Whether the work shall end.
    bool isInterrupted() const { return interrupt && interrupt(); }
    /// Whether tips may be in the danger region of the section.
    bool isBehind(std::size_t section) const { return !behind.empty() && behind[section]; }
    /// Of a section: its own, or that of all.
    double marginOf(std::size_t section) const { return margins.empty() ? margin : margins[section]; }
};

/// The poses for the tips of a path, up to the first that cannot be had.
struct ScalingResult
{
    std::vector<Eigen::Vector3d> centres;  ///< O_1 .. O_{n+1} for every pose, in the slide frame
    std::size_t first = 0;                 ///< the tip that the first pose belongs to
    std::size_t stride = 0;                ///< n + 1
    ScalingFault fault;                    ///< of the pose after the last; no failure: all are there, or interrupted

    std::size_t poses() const { return stride == 0 ? 0 : centres.size() / stride; }  ///< how many there are
    /// Joint centres of a pose, `stride` of them.
    const Eigen::Vector3d *pose(std::size_t index) const { return centres.data() + index * stride; }
};

/// The variable-dimension scaling method, steps 5 and 6: a pose for every tip of a path. Where nothing is in the way
/// all modes scale the path about the base (Eq. 5-7), so that only x_0 and psi_1 change.
///
/// Problems with crossbars are solved in the top view (TopViewScaling) whatever the mode; sections are only checked
/// then.
/// \param tips in the slide frame, dense: neighbours closer than joints may jump
/// \throws std::invalid_argument if lengths, radius, angle limit, margin or jump are out of range
ScalingResult scalePath(const ScalingProblem &problem, const std::vector<Eigen::Vector3d> &tips,
                        const ScalingOptions &options);
}  // namespace narrows
