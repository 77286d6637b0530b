// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A set of obstacles: bit k stands for the obstacles k, k + 32, k + 64, ...
using ObstacleBits = std::uint32_t;
constexpr ObstacleBits allObstacles = ~ObstacleBits(0);  ///< the set of all, however many there are

/// Whether obstacle k is in the set, or another one with its bit.
inline bool isAmong(ObstacleBits obstacles, std::size_t k)
{
    return (obstacles >> (k % 32) & 1) != 0;
}

/// Axis-parallel boxes, compared four at a time. Their ends are rounded to single precision; as rounding keeps the
/// order of numbers, boxes that meet are never taken for apart.
template <int Dim>
class BoxArrays
{
public:
    using Vector = Eigen::Matrix<double, Dim, 1>;  ///< a point

    /// Makes room for so many boxes; set() must follow for each.
    void resize(int count)
    {
        count_ = count;
        // Whole fours.
        ends_.resize(static_cast<std::size_t>(2 * Dim * ((count + 3) / 4 * 4)));
    }
    int count() const { return count_; }  ///< how many boxes there are

    /// Box i becomes the one around the segment ab and all within `room` of it.
    void set(int i, const Vector &a, const Vector &b, double room)
    {
        float *ends = ends_.data() + 2 * Dim * i;
        for (int axis = 0; axis < Dim; ++axis)
        {
            ends[axis] = static_cast<float>(std::min(a[axis], b[axis]) - room);
            ends[Dim + axis] = static_cast<float>(std::max(a[axis], b[axis]) + room);
        }
    }

    /// Which of `others` does each box meet? One that is not a number meets all.
    void findMeetings(const BoxArrays &others, std::vector<ObstacleBits> &found) const;

    /// Do boxes i and j meet?
    bool meet(int i, int j) const
    {
        for (int axis = 0; axis < Dim; ++axis)
            if (lower(i)[axis] > upper(j)[axis] || lower(j)[axis] > upper(i)[axis])
                return false;
        return true;
    }

private:
    const float *lower(int i) const { return &ends_[2 * Dim * i]; }
    const float *upper(int i) const { return &ends_[2 * Dim * i + Dim]; }

    int count_ = 0;
    std::vector<float> ends_;  ///< of one box after the other, the lower ones first
};
}  // namespace narrows
