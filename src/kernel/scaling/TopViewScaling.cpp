// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/TopViewScaling.h"

#include <algorithm>
#include <cmath>

#include "kernel/Cross.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
/// Solves front sin(a) + middle sin((a + b) / 2) = height for a in [-pi/2, pi/2], where the left side grows with a:
/// Newton's method, kept within a shrinking bracket. Nothing without a solution.
std::optional<double> frontAngle(double front, double middle, double b, double height)
{
    double low = -std::acos(0.0);
    double high = -low;
    const auto excess = [&](double a)
    {
        return front * std::sin(a) + middle * std::sin(0.5 * (a + b)) - height;
    };
    if (!(excess(low) <= 0.0 && excess(high) >= 0.0))
        return std::nullopt;
    double a = 0.0;
    for (int i = 0; i < 60; ++i)
    {
        const double value = excess(a);
        (value > 0.0 ? high : low) = a;
        const double slope = front * std::cos(a) + 0.5 * middle * std::cos(0.5 * (a + b));
        const double step = value / slope;
        const double next = a - step;
        if (std::abs(step) < 1e-13)
            return next;
        a = next > low && next < high ? next : 0.5 * (low + high);
    }
    return a;
}

double along(const Crossbar &bar, const Vector2d &point)
{
    return cross(bar.across, point);
}

Vector2d centre(const Crossbar &bar)
{
    return {bar.x, bar.offset};
}
}  // namespace

TopViewScaling::TopViewScaling(const ScalingProblem &problem, const ScalingOptions &options)
  : problem_(problem),
    options_(options),
    rules_(problem),
    fractions_(problem.fractions()),
    sides_(problem.crossbars.size(), 0),
    chain_(problem.links() + 1, Vector2d::Zero())
{
}

ScalingResult TopViewScaling::run(const std::vector<Vector3d> &tips)
{
    ScalingResult result;
    result.stride = problem_.links() + 1;
    result.centres.resize(tips.size() * result.stride);
    std::size_t done = 0;
    for (const Vector3d &tip : tips)
    {
        if (options_.isInterrupted())
            break;
        result.fault = place(tip, result.centres.data() + done * result.stride);
        if (result.fault)
            break;
        former_ = chain_;
        ++done;
    }
    result.centres.resize(done * result.stride);
    return result;
}

TopViewScaling::View TopViewScaling::view(const Crossbar &bar, const Vector3d &tip) const
{
    const double height = along(bar, tip.tail<2>());
    const double share = height / problem_.reach();
    return {{tip.x(), bar.across.dot(tip.tail<2>())}, height, std::sqrt(std::max(0.0, 1.0 - share * share))};
}

ScalingFault TopViewScaling::place(const Vector3d &tip, Vector3d *centres)
{
    const std::optional<std::size_t> bar = blocker(tip);
    if (!bar)
    {
        for (std::size_t i = 0; i < chain_.size(); ++i)
            chain_[i] = fractions_[i] * tip.tail<2>();
        const ScalingFault fault = rules_.lift(chain_, tip.x(), centres);
        return fault ? fault : rules_.check(centres);
    }
    ScalingFault first{ScalingFailure::NoCandidate};
    for (const std::size_t link : linksToBend(*bar, tip))
    {
        const std::optional<ScalingFault> fault = bend(*bar, link, tip, centres);
        if (!fault)
            continue;
        if (!*fault && !jumps())
        {
            bent_ = link;
            return {};
        }
        if (first.failure == ScalingFailure::NoCandidate)
            first = *fault ? *fault : ScalingFault{ScalingFailure::Jump};
    }
    return first;
}

/// The link bent last, then those that end before the bar in the straight pose, from the last one on, then the rest.
std::vector<std::size_t> TopViewScaling::linksToBend(std::size_t index, const Vector3d &tip) const
{
    const Crossbar &bar = problem_.crossbars[index];
    const View seen = view(bar, tip);
    const double reach = seen.shrink * problem_.reach();
    const double toTip = std::max(0.0, seen.tip.x() - bar.x) / reach;
    const double share = 1.0 - toTip / std::sqrt(std::max(1e-12, 1.0 - std::pow(seen.tip.y() / reach, 2)));
    std::vector<std::size_t> links;
    if (bent_ > 0)
        links.push_back(bent_);
    for (std::size_t i = problem_.links() - 1; i-- > 1;)
        if (fractions_[i + 1] <= share)
            links.push_back(i);
    for (std::size_t i = 1; i + 1 < problem_.links(); ++i)
        if (fractions_[i + 1] > share)
            links.push_back(i);
    return links;
}

std::optional<std::size_t> TopViewScaling::blocker(const Vector3d &tip)
{
    for (std::size_t i = 0; i < problem_.crossbars.size(); ++i)
    {
        const Crossbar &bar = problem_.crossbars[i];
        const View seen = view(bar, tip);
        const double reach = seen.shrink * problem_.reach();
        const double rest = reach * reach - seen.tip.y() * seen.tip.y();
        if (!(rest > 0.0))
            continue;
        const Vector2d base(seen.tip.x() - std::sqrt(rest), 0.0);
        const int side = cross(seen.tip - base, centre(bar) - base) > 0.0 ? 1 : -1;
        const double far = bar.radius + options_.margin;
        const bool clear = squaredDistance(base, seen.tip, centre(bar)) >= far * far;
        if (sides_[i] == 0)
            sides_[i] = side;
        if (!clear || side != sides_[i])
            return i;
    }
    return std::nullopt;
}

/// A pose with the given link bent; nothing if the equation has no solution.
std::optional<ScalingFault> TopViewScaling::bend(std::size_t index, std::size_t link, const Vector3d &tip,
                                                 Vector3d *centres)
{
    const Crossbar &bar = problem_.crossbars[index];
    const View seen = view(bar, tip);
    const Vector2d fromBar = seen.tip - centre(bar);
    const double far = bar.radius + options_.margin;
    if (fromBar.norm() <= far)
        return ScalingFault{ScalingFailure::TipBlocked, static_cast<int>(problem_.links()) - 1};
    const double rear = std::atan2(fromBar.y(), fromBar.x()) + std::asin(sides_[index] * far / fromBar.norm());

    const double whole = seen.shrink * problem_.reach();
    const double front = whole * fractions_[link];
    const double middle = whole * (fractions_[link + 1] - fractions_[link]);
    const double behind = whole - front - middle;
    const std::optional<double> angle = frontAngle(front, middle, rear, seen.tip.y() - behind * std::sin(rear));
    if (!angle)
        return std::nullopt;
    const Vector2d up(-bar.across.y(), bar.across.x());
    double across = 0.0;
    for (std::size_t i = 0; i < chain_.size(); ++i)
    {
        if (i > 0)
        {
            const double direction = i - 1 < link ? *angle : (i - 1 == link ? 0.5 * (*angle + rear) : rear);
            across += whole * (fractions_[i] - fractions_[i - 1]) * std::sin(direction);
        }
        chain_[i] = across * bar.across + fractions_[i] * seen.height * up;
    }
    chain_.back() = tip.tail<2>();  // exactly
    const ScalingFault fault = rules_.lift(chain_, tip.x(), centres);
    return fault ? fault : rules_.check(centres);
}

bool TopViewScaling::jumps() const
{
    for (std::size_t i = 0; i < former_.size(); ++i)
        if ((chain_[i] - former_[i]).norm() > options_.maxJump)
            return true;
    return false;
}
}  // namespace narrows
