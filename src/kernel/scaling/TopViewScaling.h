// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/scaling/PathScaling.h"
#include "kernel/scaling/PoseRules.h"

namespace narrows
{
/// Scaling past a crossbar, in the top view along its axis (the paper's obs3; the rule is ours, the paper only
/// describes what comes out).
///
/// All links rise alike along the bar: in the top view their lengths shrink by one factor. A straight arm that is clear
/// of the bar's danger region on the side where it has been stays straight. Else the links behind link a lie straight
/// on a tangent of the region, those before it are straight too, and link a halves the angle between them: one equation
/// for one angle. Link a is the last one that ends before the bar, and stays the same as long as that pose keeps the
/// rules.
class TopViewScaling
{
public:
    /// Refers to both, which must outlive it.
    TopViewScaling(const ScalingProblem &problem, const ScalingOptions &options);

    /// A pose for every tip, up to the first that cannot be had.
    ScalingResult run(const std::vector<Eigen::Vector3d> &tips);

private:
    /// The tip and the arm as seen along the bar.
    struct View
    {
        Eigen::Vector2d tip;  ///< x, and the coordinate across the bar
        double height;        ///< of the tip along the bar
        double shrink;        ///< of all links in the view
    };

    View view(const Crossbar &bar, const Eigen::Vector3d &tip) const;
    ScalingFault place(const Eigen::Vector3d &tip, Eigen::Vector3d *centres);
    std::vector<std::size_t> linksToBend(std::size_t bar, const Eigen::Vector3d &tip) const;
    /// The first bar that the straight arm is not clear of on its side.
    std::optional<std::size_t> blocker(const Eigen::Vector3d &tip);
    std::optional<ScalingFault> bend(std::size_t bar, std::size_t link, const Eigen::Vector3d &tip,
                                     Eigen::Vector3d *centres);
    bool jumps() const;

    const ScalingProblem &problem_;
    const ScalingOptions &options_;
    PoseRules rules_;
    std::vector<double> fractions_;
    std::vector<int> sides_;  ///< per bar: 1 if it lies to the left of the arm, -1 to the right, 0 not known yet
    std::size_t bent_ = 0;    ///< the link that was bent last; 0: none yet
    SectionChain chain_, former_;
};
}  // namespace narrows
