// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/RiseSum.h"

#include <stdexcept>

#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
RiseSum::RiseSum(double start, double duration, std::vector<Rise> rises, std::vector<double> parts)
  : start_(start), duration_(duration), rises_(std::move(rises)), parts_(std::move(parts))
{
    bool finite = std::isfinite(start_) && std::isfinite(duration_);
    for (const double part : parts_)
        finite = finite && std::isfinite(part);
    if (!finite || !(duration_ > 0.0) || parts_.size() != rises_.size())
        throw std::invalid_argument("a sum of rises needs a duration and a finite part for each rise");
}

Series<4, Enclosure> RiseSum::over(std::size_t, const Enclosure &t) const
{
    Series<4, Enclosure> sum{};
    sum[0] = start_;
    const double rate = 1.0 / duration_;
    const Enclosure x(std::min(t.lower * rate, 1.0), std::min(t.upper * rate, 1.0));
    for (std::size_t i = 0; i < rises_.size(); ++i)
        addRise<4, Enclosure>(sum, rises_[i], x, parts_[i], rate);
    return sum;
}

std::vector<Rise> restingRises(int count)
{
    constexpr double slowest = -1.5, range = 4.8;
    std::vector<Rise> rises;
    for (int i = 0; i < count; ++i)
        rises.push_back(*Rise::resting(std::exp(slowest + range * i / (count - 1))));
    return rises;
}
}  // namespace narrows
