// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/BoxArrays.h"

#include <cstring>

namespace narrows
{
namespace
{
// Four numbers that the processor treats at once: what every one of its kind can do, without asking which it is.
using Floats [[gnu::vector_size(16)]] = float;
using Bits [[gnu::vector_size(16)]] = std::int32_t;
}  // namespace

template <int Dim>
void BoxArrays<Dim>::findMeetings(const BoxArrays &others, std::vector<ObstacleBits> &found) const
{
    constexpr int rows = 2 * Dim;
    found.resize(ends_.size() / rows);
    for (std::size_t first = 0; first < found.size(); first += 4)
    {
        Floats ends[rows];
        const float *box = &ends_[first * rows];
        for (int row = 0; row < rows; ++row)
            ends[row] = Floats{box[row], box[row + rows], box[row + 2 * rows], box[row + 3 * rows]};
        Bits bits = {};
        const float *other = others.ends_.data();
        for (int k = 0; k < others.count_; ++k, other += rows)
        {
            Bits apart = {};
            for (int axis = 0; axis < Dim; ++axis)
                apart |= (ends[axis] > other[Dim + axis]) | (ends[Dim + axis] < other[axis]);
            bits |= ~apart & static_cast<std::int32_t>(1u << (k % 32));
        }
        std::memcpy(&found[first], &bits, sizeof bits);
    }
}

template class BoxArrays<2>;
template class BoxArrays<3>;
}  // namespace narrows
