// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/scaling/ChainEasing.h"
#include "kernel/scaling/Outline.h"
#include "kernel/scaling/SectionScaling.h"
#include "kernel/scaling/TautString.h"

namespace narrows
{
/// Scaling along a taut string: P_i is the point at the fraction k_{i,n+1} of the string from the base around the
/// danger regions to the tip, so that every bend of the string is a new zoom centre. No link can be too short for a
/// string shorter than the arm. Without obstacles this is the paper's scaling.
/// Where links would cut corners, ChainEasing helps.
///
/// For a tip inside a danger region that is behind it, the string ends where the ray from the region's centre through
/// the tip leaves it, and the rest of the way to the tip is straight: the last links pass before the obstacle.
class TautScaling final : public SectionScaling
{
public:
    /// Refers to both, which must outlive it.
    TautScaling(const ScalingProblem &problem, const ScalingOptions &options);

    ScalingFault place(const Eigen::Vector2d &tip, SectionChain &chain) override;

    const TautString &string() const { return string_; }  ///< as the last pose left it

private:
    std::optional<std::size_t> blockedBy(const Eigen::Vector2d &tip) const;

    const ScalingProblem &problem_;
    const ScalingOptions &options_;
    std::vector<double> fractions_;
    ChainEasing easing_;
    TautString string_;
    std::vector<Outline> holds_;  ///< per section behind the tips: where the string may end; empty for the others
};
}  // namespace narrows
