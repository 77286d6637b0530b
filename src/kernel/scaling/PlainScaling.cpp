// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/PlainScaling.h"

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// Points this much inside a region, relative to the margin, are on its boundary: hits are only as exact as that.
constexpr double boundary = 1e-9;
}  // namespace

bool AuxiliaryLines::isInside(std::size_t section, const Vector2d &point) const
{
    return problem_.sections[section].isCloser(point, point, options_.marginOf(section) * (1.0 - boundary));
}

bool AuxiliaryLines::isDangerous(const Vector2d &point) const
{
    for (std::size_t s = 0; s < problem_.sections.size(); ++s)
        if (isInside(s, point))
            return true;
    return false;
}

void AuxiliaryLines::candidates(const Vector2d &point, std::vector<Vector2d> &result, std::size_t &alongY) const
{
    result.clear();
    alongY = 0;
    if (!isDangerous(point))
    {
        result.push_back(point);
        return;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
        for (std::size_t s = 0; s < problem_.sections.size(); ++s)
        {
            if (!isInside(s, point))
                continue;
            const std::optional<Interval> hits =
                problem_.sections[s].crossing(axis, point[1 - axis], options_.marginOf(s));
            if (!hits)
                continue;
            for (const double value : {hits->lower, hits->upper})
            {
                Vector2d hit = point;
                hit[axis] = value;
                if (!isDangerous(hit))
                    result.push_back(hit);
            }
        }
        if (axis == 0)
            alongY = result.size();
    }
}

PlainScaling::PlainScaling(const ScalingProblem &problem, const ScalingOptions &options)
  : problem_(problem),
    lines_(problem, options),
    vertical_(options.mode == ScalingMode::PaperVertical),
    fractions_(problem.fractions())
{
}

int PlainScaling::choose(const Vector2d &former, std::size_t alongY) const
{
    const std::size_t first = vertical_ && alongY < candidates_.size() ? alongY : 0;
    int best = -1;
    double least = 0.0;
    for (std::size_t i = first; i < candidates_.size(); ++i)
    {
        const double square = (candidates_[i] - former).squaredNorm();
        if (best < 0 || square < least)
        {
            best = static_cast<int>(i);
            least = square;
        }
    }
    return best;
}

ScalingFault PlainScaling::place(const Vector2d &tip, SectionChain &chain)
{
    const std::size_t n = problem_.links();
    const bool fresh = chain.empty();
    chain.resize(n + 1, Vector2d::Zero());
    chain[n] = tip;
    for (std::size_t i = n; i-- > 1;)
    {
        const Vector2d scaled = fractions_[i] / fractions_[i + 1] * chain[i + 1];
        std::size_t alongY = 0;
        lines_.candidates(scaled, candidates_, alongY);
        const int chosen = choose(fresh ? scaled : chain[i], alongY);
        if (chosen < 0)
            return {ScalingFailure::NoCandidate, static_cast<int>(i)};
        chain[i] = candidates_[static_cast<std::size_t>(chosen)];
        if ((chain[i + 1] - scaled).norm() > 0.0 && (chain[i + 1] - chain[i]).norm() >= problem_.lengths[i])
            return {ScalingFailure::Span, static_cast<int>(i)};
    }
    chain[0].setZero();
    return {};
}
}  // namespace narrows
