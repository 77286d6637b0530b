// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SampledMotionValidator.h"

#include <algorithm>

#include "validity/StraightMotion.h"

namespace narrows
{
/// The states k / n of a motion, k = 1 ... n - 1.
class SampledMotionValidator::Samples
{
public:
    Samples(const SampledMotionValidator &validator, const ob::State *from, const ob::State *to)
      : validator_(validator),
        motion_(straightMotion(*validator.space_, from, to)),
        parts_(std::max<Eigen::Index>(1, validator.space_->validSegmentCount(from, to)))
    {
    }

    Eigen::Index parts() const { return parts_; }
    /// How many times it takes to look at all.
    Eigen::Index batches() const { return (parts_ - 1 + most - 1) / most; }

    /// The first of the states first, first + stride, ... that is not free, at most `most` of them; parts() if all are.
    Eigen::Index firstTouching(Eigen::Index first, Eigen::Index stride) const
    {
        thread_local Eigen::MatrixXd states;
        thread_local std::vector<char> free;
        const Eigen::Index count = std::min(most, (parts_ - first + stride - 1) / stride);
        states.resize(count, motion_.q.size());
        for (Eigen::Index row = 0; row < count; ++row)
            states.row(row) =
                motion_.q + static_cast<double>(first + row * stride) / static_cast<double>(parts_) * motion_.delta;
        validator_.checker_->areFree(states, free);
        validator_.counts_->stateChecks.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
        validator_.counts_->placements.fetch_add(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
        const auto touching = std::find(free.begin(), free.end(), 0);
        return touching == free.end() ? parts_ : first + stride * (touching - free.begin());
    }

    static constexpr Eigen::Index most = 16;

private:
    const SampledMotionValidator &validator_;
    const StraightMotion &motion_;
    Eigen::Index parts_;
};

/// Every batch is spread over the whole motion, so that the first is likely to meet what is in the way.
bool SampledMotionValidator::checkMotion(const ob::State *from, const ob::State *to) const
{
    if (!si_->isValid(to))
        return record(false);
    const Samples samples(*this, from, to);
    for (Eigen::Index batch = 0; batch < samples.batches(); ++batch)
        if (samples.firstTouching(1 + batch, samples.batches()) < samples.parts())
            return record(false);
    return record(true);
}

bool SampledMotionValidator::checkMotion(const ob::State *from, const ob::State *to,
                                         std::pair<ob::State *, double> &lastValid) const
{
    const Samples samples(*this, from, to);
    Eigen::Index touching = samples.parts();
    for (Eigen::Index first = 1; first < samples.parts() && touching == samples.parts(); first += Samples::most)
        touching = samples.firstTouching(first, 1);
    if (touching == samples.parts() && si_->isValid(to))
        return record(true);
    stopAt(from, to, static_cast<double>(touching - 1) / static_cast<double>(samples.parts()), lastValid);
    return record(false);
}
}  // namespace narrows
