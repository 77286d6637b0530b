// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Progress.h"

#include <string>

#include <fmt/format.h>

namespace narrows
{
namespace
{
std::string duration(double seconds)
{
    const auto whole = static_cast<long>(seconds + 0.5);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}
}  // namespace

Progress::Progress(std::size_t total, std::ostream &out, bool terminal) : total_(total), out_(out), terminal_(terminal)
{
}

void Progress::step(bool solved)
{
    ++done_;
    solved_ += solved ? 1 : 0;
    const Clock::time_point now = Clock::now();
    const auto interval = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000);
    if (now - printed_ < interval && done_ < total_)
        return;
    printed_ = now;
    print(std::chrono::duration<double>(now - begin_).count());
}

void Progress::print(double elapsed)
{
    const double share = static_cast<double>(done_) / static_cast<double>(total_);
    const double left = elapsed / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string counts = fmt::format("{}/{} runs, {} solved, {} elapsed, {} left", done_, total_, solved_,
                                           duration(elapsed), duration(left));
    if (!terminal_)
    {
        out_ << counts << std::endl;
        return;
    }
    constexpr std::size_t width = 30;
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
    out_ << "\r[" << std::string(filled, '#') << std::string(width - filled, '.') << "] " << counts << "\033[K"
         << std::flush;
}

void Progress::finish()
{
    if (terminal_ && done_ > 0)
        out_ << std::endl;
}
}  // namespace narrows
