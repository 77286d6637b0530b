// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// When, along lambda, each joint goes its part of the way D from start to goal. Without holds, all move at lambda's
/// pace. A joint that is held at an end rests there for a share of lambda's way and makes up for it, once continuously
/// differentiably, on the rest. So a link that lies in a throat does not turn while the others draw it out: what
/// remains to be kept is its place across the throat, which one row of W can do.
struct JointSchedule
{
    std::vector<int> held;  ///< per joint: 0 not held, -1 at the start, +1 at the goal; empty: none is
    double share = 0.0;     ///< in [0, 1), of lambda's way

    /// Whether no joint is held back.
    bool empty() const
    {
        return std::all_of(held.begin(), held.end(), [](int hold) { return hold == 0; });
    }

    /// The part of its way that a joint has gone at lambda, and its derivative.
    struct Progress
    {
        double value;  ///< 0 at lambda = 0, 1 at lambda = 1
        double rate;   ///< of change with lambda
    };
    /// \param joint index in the configuration
    Progress progress(std::size_t joint, double lambda) const
    {
        const int hold = held.empty() ? 0 : held[joint];
        if (hold == 0)
            return {lambda, 1.0};
        // What is left of the way, seen from the end where the joint is held.
        const double rest = (hold > 0 ? lambda : 1.0 - lambda) / (1.0 - share);
        if (rest >= 1.0)
            return {hold > 0 ? 1.0 : 0.0, 0.0};
        const double left = 1.0 - rest;
        const double part = 1.0 - left * left;
        return {hold > 0 ? part : 1.0 - part, 2.0 * left / (1.0 - share)};
    }
};
}  // namespace narrows
