// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace narrows
{
/// Random numbers that are the same everywhere: the engine's sequence is fixed by the C++ standard, what the standard's
/// distributions make of it is not. Two draws need two statements: in which order a compiler evaluates arguments and
/// operands is its own affair.
class RandomNumbers
{
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [lower, upper), to 53 bits.
    double uniform(double lower, double upper)
    {
        constexpr double unit = 1.0 / 9007199254740992.0;  // 2^-53
        return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * unit);
    }

    /// A whole number from lowest to highest, both included; no more uneven than 2^-53.
    int whole(int lowest, int highest) { return lowest + static_cast<int>(uniform(0.0, highest - lowest + 1.0)); }

    bool coin() { return (engine_() >> 63) != 0; }

private:
    std::mt19937_64 engine_;
};
}  // namespace narrows
