// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace narrows
{
/// Cosines and sines of many angles at once, several times faster than one by one.
struct SineCosineBlock
{
    static constexpr int most = 32;    ///< angles at once
    static constexpr int worthIt = 4;  ///< fewer are as fast one by one

    /// Sets cosines[i] and sines[i] of angles[i] for i < count <= most. Off by at most 2.5e-16 up to |angle| = 1e5;
    /// beyond, and for what is not finite, the standard library's. The same bits on every processor, whatever vector
    /// instructions it has. What lies beyond `count` is overwritten.
    void evaluate(int count);

    // Aligned as the longest vectors are, so that no loop has loose ends.
    alignas(64) double angles[most];   ///< radians
    alignas(64) double cosines[most];  ///< of the angles, after evaluate()
    alignas(64) double sines[most];    ///< of the angles, after evaluate()
};
}  // namespace narrows
