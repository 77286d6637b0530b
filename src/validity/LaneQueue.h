// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "validity/LaneGeometry.h"

namespace narrows::lanes
{
/// Segments of several blocks that wait until as many of them have come together as can be looked at side by side.
struct Queue
{
    /// \return whether it is full
    bool add(const Points &from, const Points &to, int lane, Eigen::Index row)
    {
        a.x[size] = from.x[lane];
        a.y[size] = from.y[lane];
        b.x[size] = to.x[lane];
        b.y[size] = to.y[lane];
        rows[size] = row;
        return ++size == count;
    }

    Points a, b;
    Eigen::Index rows[count];
    int size = 0;
};

/// Calls visit(l) for each bit l.
template <class Visit>
void forEachBit(std::uint32_t bits, const Visit &visit)
{
    for (; bits != 0; bits &= bits - 1)
        visit(__builtin_ctz(bits));
}

inline std::uint32_t lanesThatMeet(const Meetings &meetings, int k)
{
    std::uint32_t result = 0;
    for (int l = 0; l < count; ++l)
        result |= (meetings.of[l] >> k & 1u) << l;
    return result;
}
}  // namespace narrows::lanes
