// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>

namespace narrows
{
/// Says how far a campaign is: a bar with the time left on a terminal, otherwise a plain line every ten seconds.
class Progress
{
public:
    Progress(std::size_t total, std::ostream &out, bool terminal);

    /// One more run has ended.
    void step(bool solved);
    /// Ends the bar's line.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    void print(double elapsed);

    std::size_t total_;
    std::ostream &out_;
    bool terminal_;
    std::size_t done_ = 0;
    std::size_t solved_ = 0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point printed_ = begin_;
};
}  // namespace narrows
