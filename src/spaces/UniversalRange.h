// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SpatialArm.h"

namespace narrows
{
/// The angles that the two joints of a universal joint may have together: a convex set, the cone of the largest bend
/// within the limits of either joint.
class UniversalRange
{
public:
    /// \param limit which joints, and how far they may bend together
    /// \param first, second limits of the two joints; none: the cone alone limits them
    /// \throws std::invalid_argument if no pair of angles is allowed
    UniversalRange(const UniversalLimit &limit, const std::optional<Interval> &first,
                   const std::optional<Interval> &second);

    const UniversalLimit &limit() const { return limit_; }  ///< which joints, and how far they may bend together
    ///@{
    /// Interval that holds all allowed values of the one and the other joint.
    const Interval &first() const { return first_; }
    const Interval &second() const { return second_; }
    ///@}

    /// To 1e-12 rad: a state between two states at the limit is allowed whatever the rounding.
    bool contains(const double *joints) const;
    /// Moves the two angles into the set, if they are outside: into the intervals, then straight towards the allowed
    /// angles that bend least. Values that are inside stay as they are.
    void enforce(double *joints) const;

private:
    bool bendsAtMost(double squaredSine, double a, double b) const;

    UniversalLimit limit_;
    Interval first_;
    Interval second_;
    double most_;       ///< sin^2 of half the largest bend
    double tolerated_;  ///< the same for what contains() lets pass
};
}  // namespace narrows
