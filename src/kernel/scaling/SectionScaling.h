// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/PathScaling.h"

namespace narrows
{
/// Finds the projections of the joint centres for one tip after another (step 5).
class SectionScaling
{
public:
    virtual ~SectionScaling() = default;

    /// \param tip projection of the next tip, near the one before
    /// \param chain out: P_1 .. P_{n+1}; in: those for the tip before, or empty
    virtual ScalingFault place(const Eigen::Vector2d &tip, SectionChain &chain) = 0;
};
}  // namespace narrows
