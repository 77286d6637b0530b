// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/ScalingProblem.h"

namespace narrows
{
/// Step 6 of the paper, from the section plane back to space, and the rules that every pose has to keep.
class PoseRules
{
public:
    /// Refers to it: it must outlive the rules.
    explicit PoseRules(const ScalingProblem &problem);

    /// Joint centres O_1 .. O_{n+1} over their projections, from the tip's x down (Eq. 7).
    /// \param centres n + 1 places to write to
    /// \return Span with the link if one is too short; the centres are unspecified then
    ScalingFault lift(const SectionChain &chain, double tipX, Eigen::Vector3d *centres) const;

    /// Slide, link angles and clearances of a lifted pose, in this order, from the base on.
    ScalingFault check(const Eigen::Vector3d *centres) const;

    /// Whether the joint between two links turns further than it may.
    /// \param lengths the product of theirs
    bool isBent(const Eigen::Vector3d &before, const Eigen::Vector3d &link, double lengths) const
    {
        return before.dot(link) < cosine_ * lengths;
    }
    /// The first section that a link between two centres comes too close to; -1: none. A section counts only where it
    /// is along the slide.
    int blockingSection(const Eigen::Vector3d &from, const Eigen::Vector3d &to) const;

private:
    int blockingCrossbar(const Eigen::Vector3d &from, const Eigen::Vector3d &to) const;

    const ScalingProblem &problem_;
    double cosine_;  ///< of the largest link angle, a little more
    double needed_;  ///< least distance between a link's axis and a section, a little more than the radius
};

/// The link angles psi_1 .. psi_n of a pose (Eq. 2).
std::vector<double> linkAngles(const ScalingProblem &problem, const Eigen::Vector3d *centres);
}  // namespace narrows
