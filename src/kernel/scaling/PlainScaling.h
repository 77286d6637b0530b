// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/SectionScaling.h"

namespace narrows
{
/// The auxiliary lines of step 5 (Figure 8): through a point in danger regions, along y and along z, to the boundaries
/// of the regions it is in.
class AuxiliaryLines
{
public:
    /// Refers to both, which must outlive it.
    AuxiliaryLines(const ScalingProblem &problem, const ScalingOptions &options) : problem_(problem), options_(options)
    {
    }

    /// Whether the point lies in a danger region.
    bool isDangerous(const Eigen::Vector2d &point) const;

    /// Where P_i may be if it is to be at `point`: there, or the hits that are inside no other region.
    /// \param alongY of the hits, how many were made along y; they come first
    void candidates(const Eigen::Vector2d &point, std::vector<Eigen::Vector2d> &result, std::size_t &alongY) const;

private:
    bool isInside(std::size_t section, const Eigen::Vector2d &point) const;

    const ScalingProblem &problem_;
    const ScalingOptions &options_;
};

/// Steps 3 and 5 as printed: from the tip inward, P_i = k_{i,i+1} P_{i+1} (Eq. 8-10) or, if that is in a danger region,
/// the candidate nearest to the P_i before.
class PlainScaling final : public SectionScaling
{
public:
    /// Refers to both, which must outlive it.
    PlainScaling(const ScalingProblem &problem, const ScalingOptions &options);

    ScalingFault place(const Eigen::Vector2d &tip, SectionChain &chain) override;

private:
    /// The candidate to take, counted from the first; -1: there is none.
    int choose(const Eigen::Vector2d &former, std::size_t alongY) const;

    const ScalingProblem &problem_;
    AuxiliaryLines lines_;
    bool vertical_;  ///< candidates along z are preferred to those along y
    std::vector<double> fractions_;
    std::vector<Eigen::Vector2d> candidates_;
};
}  // namespace narrows
