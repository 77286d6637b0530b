// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/scaling/PathScaling.h"

namespace narrows
{
/// Moves the joints of a pose a little, in the section plane, where scaling has not kept the rules: a link whose chord
/// cuts a corner pushes its joints away from the section, a joint that is bent too much straightens itself and its
/// neighbours. Base and tip stay.
///
/// What it does depends on the pose alone and begins at nothing where a rule begins to be broken, so that poses that
/// were near each other stay so.
class ChainEasing
{
public:
    /// Refers to both, which must outlive it.
    ChainEasing(const ScalingProblem &problem, const ScalingOptions &options);

    /// At most `options.easing` rounds over all links and joints; it may be in vain.
    /// \param passed a section that does not push the links from `links` on
    void ease(SectionChain &chain, std::optional<std::size_t> passed, std::size_t links) const;

private:
    bool push(SectionChain &chain, std::size_t link, std::size_t section) const;
    bool straighten(SectionChain &chain, std::size_t joint) const;

    const ScalingProblem &problem_;
    const ScalingOptions &options_;
    double wantedAngle_;          ///< that bends shall not exceed
    double cosine_;               ///< of it
    std::vector<double> wanted_;  ///< per section: distance that links shall keep
};
}  // namespace narrows
