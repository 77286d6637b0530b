// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/ChainEasing.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// Easing aims at a little more than the rules ask for, as it comes near its aim without reaching it: the radius and
/// this share of what the margin is more, and this share of the largest link angle.
constexpr double marginShare = 0.1;
constexpr double angleShare = 0.98;
/// A link that is touched close to where it is held would have to swing far; it moves as if touched farther out.
constexpr double leastWeight = 0.2;

/// How far a unit vector with this projection points out of the section plane.
double rise(const Vector2d &slope)
{
    return std::sqrt(std::max(0.0, 1.0 - slope.squaredNorm()));
}
}  // namespace

ChainEasing::ChainEasing(const ScalingProblem &problem, const ScalingOptions &options)
  : problem_(problem),
    options_(options),
    wantedAngle_(angleShare * problem.maxAngle),
    cosine_(wantedAngle_ < 3.0 ? std::cos(wantedAngle_) : -2.0)
{
    for (std::size_t s = 0; s < problem.sections.size(); ++s)
        wanted_.push_back(problem.radius + marginShare * (options.marginOf(s) - problem.radius));
}

void ChainEasing::ease(SectionChain &chain, std::optional<std::size_t> passed, std::size_t links) const
{
    for (int round = 0; round < options_.easing; ++round)
    {
        bool kept = true;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        {
            kept = !straighten(chain, i) && kept;
            for (std::size_t s = 0; s < problem_.sections.size(); ++s)
                if (i < links || s != passed)
                    kept = !push(chain, i, s) && kept;
        }
        if (kept)
            return;
    }
}

/// Moves the joints of a link that is too close to a section. False if it is not.
bool ChainEasing::push(SectionChain &chain, std::size_t link, std::size_t index) const
{
    Vector2d &from = chain[link];
    Vector2d &to = chain[link + 1];
    const ConvexSection &section = problem_.sections[index];
    if (!section.isCloser(from, to, wanted_[index]))
        return false;
    const ConvexSection::Contact contact = section.contact(from, to);
    // The shares of the two joints in moving the nearest point by the whole distance.
    const double first = link == 0 ? 0.0 : 1.0 - contact.fraction;
    const double second = link + 2 == chain.size() ? 0.0 : contact.fraction;
    const double weight = (1.0 - contact.fraction) * first + contact.fraction * second;
    const Vector2d way = (wanted_[index] - contact.distance) / std::max(weight, leastWeight) * contact.away;
    from += first * way;
    to += second * way;
    return true;
}

/// Moves a joint that is bent too much and its neighbours, all together as little as it takes to first order. False if
/// it is not.
bool ChainEasing::straighten(SectionChain &chain, std::size_t joint) const
{
    const bool base = joint == 0;
    const double after = problem_.lengths[joint];
    const double before = base ? 1.0 : problem_.lengths[joint - 1];
    const Vector2d slope = (chain[joint + 1] - chain[joint]) / after;
    const Vector2d former =
        base ? Vector2d(problem_.forward.tail<2>()) : Vector2d((chain[joint] - chain[joint - 1]) / before);
    const double cosine = slope.dot(former) + rise(slope) * rise(former);
    if (cosine >= cosine_)
        return false;
    const double angle = std::acos(std::max(-1.0, cosine));
    const Vector2d excess = (1.0 - wantedAngle_ / angle) * (slope - former);
    // How the difference of the slopes changes with the joint before, this one and the next.
    const double first = joint < 2 ? 0.0 : 1.0 / before;
    const double middle = base ? 0.0 : -1.0 / before - 1.0 / after;
    const double last = joint + 2 == chain.size() ? 0.0 : 1.0 / after;
    const double squares = first * first + middle * middle + last * last;
    if (squares == 0.0)
        return false;
    if (!base)
        chain[joint - 1] -= first / squares * excess;
    chain[joint] -= middle / squares * excess;
    chain[joint + 1] -= last / squares * excess;
    return true;
}
}  // namespace narrows
