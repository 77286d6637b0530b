// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace narrows
{
/// Whether one of at most `most` draws will do; the first that does is the last that is made.
/// \param draw makes something of fresh random numbers and says whether it will do
template <typename Draw>
bool oneWillDo(int most, Draw draw)
{
    for (int i = 0; i < most; ++i)
        if (draw())
            return true;
    return false;
}

/// Draws until a draw will do.
/// \throws std::invalid_argument if none of `most` does
template <typename Draw>
void drawUntilOneWillDo(int most, Draw draw)
{
    if (!oneWillDo(most, draw))
        throw std::invalid_argument("no such scene was found in " + std::to_string(most) + " draws");
}
}  // namespace narrows
