// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PlanarMotion.h"

#include <algorithm>
#include <cmath>

namespace narrows::proof
{
using Eigen::Vector2d;

PlanarMotion::PlanarMotion(const PlanarArm &arm)
  : arm_(arm), points_(arm.links().size() + 1), rates_(arm.links().size()), links_(arm.links().size())
{
}

void PlanarMotion::place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t)
{
    points_[0] = {arm_.base(), Vector2d::Zero(), 0.0, 0.0};
    int value = 0;
    if (const auto &slide = arm_.slide())
    {
        const double rate = to[value] - from[value];
        points_[0].position += (from[value] + t * rate) * slide->axis;
        points_[0].velocity = rate * slide->axis;
        points_[0].travel = std::abs(rate);
        ++value;
    }
    for (int link = 0; link < arm_.linkCount(); ++link, ++value)
    {
        const double length = arm_.links()[link].length;
        const double rate = to[value] - from[value];
        const double angle = from[value] + t * rate;
        const Vector2d arm = length * Vector2d(std::cos(angle), std::sin(angle));
        const MovingPoint<2> &carrier = baseOf(link);
        points_[link + 1] = {carrier.position + arm, carrier.velocity + rate * Vector2d(-arm.y(), arm.x()),
                             carrier.travel + length * std::abs(rate), carrier.bend + length * rate * rate};
        rates_[link] = rate;
        links_[link] = {carrier, points_[link + 1]};
    }
}

/// Only the links between the two count, by their rates against the first's.
MovingPair<2> PlanarMotion::between(int first, int second) const
{
    const auto atRest = [](const MovingPoint<2> &point)
    {
        return MovingPoint<2>{point.position, Vector2d::Zero(), 0.0, 0.0};
    };
    MovingPair<2> pair{{atRest(baseOf(first)), atRest(tipOf(first))}, {atRest(baseOf(second)), atRest(tipOf(second))}};
    const auto carry = [&](int link, MovingPoint<2> &point)
    {
        const double rate = rates_[link] - rates_[first], length = arm_.links()[link].length;
        const Vector2d arm = tipOf(link).position - baseOf(link).position;
        point.velocity += rate * Vector2d(-arm.y(), arm.x());
        point.travel += std::abs(rate) * length;
        point.bend += rate * rate * length;
    };
    const auto carryFrom = [&](int &link, int carried, MovingSegment<2> &segment)
    {
        carry(link, segment.to);
        if (link != carried)
            carry(link, segment.from);
        link = arm_.links()[link].parent;
    };
    for (int one = first, other = second; one != other;)  // the later link cannot carry the earlier one
        if (one > other)
            carryFrom(one, first, pair.first);
        else
            carryFrom(other, second, pair.second);
    return pair;
}

bool PlanarMotion::areNeighbours(int first, int second) const
{
    const int carrier = arm_.links()[first].parent, other = arm_.links()[second].parent;
    return carrier == other || carrier == second || other == first;
}

/// Angles enter with their own rounding, which grows with the number of turns: hence the largest value as a factor.
double PlanarMotion::extent(const std::vector<Eigen::VectorXd> &path) const
{
    double largestValue = 1.0;
    for (const Eigen::VectorXd &row : path)
        largestValue = std::max(largestValue, row.cwiseAbs().maxCoeff());
    return arm_.base().norm() + arm_.reach() * largestValue + (arm_.slide() ? largestValue : 0.0);
}

double PlanarMotion::rounding(double extent) const
{
    return (32 + 4 * arm_.linkCount()) * std::numeric_limits<double>::epsilon() * extent;
}
}  // namespace narrows::proof
