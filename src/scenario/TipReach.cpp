// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/TipReach.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace narrows
{
namespace
{
double distanceToSegment(const Eigen::Vector3d &from, const Eigen::Vector3d &to, const Eigen::Vector3d &point)
{
    const Eigen::Vector3d along = to - from;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp(along.dot(point - from) / square, 0.0, 1.0) : 0.0;
    return (point - from - t * along).norm();
}
}  // namespace

void checkReach(const Field &field, const TipReach &goal)
{
    const double total = std::accumulate(goal.lengths.begin(), goal.lengths.end(), 0.0);
    const double longest = *std::max_element(goal.lengths.begin(), goal.lengths.end());
    const double nearest = 2.0 * longest - total;
    const double least = distanceToSegment(goal.baseFrom, goal.baseTo, goal.point);
    const double most = std::max((goal.point - goal.baseFrom).norm(), (goal.point - goal.baseTo).norm());
    if (least - goal.tolerance > total)
        field.fault(fmt::format("out of reach: {:.6g} away from the base, but the chain to link {} is {:.6g} long",
                                least, goal.number, total));
    else if (most + goal.tolerance < nearest)
        field.fault(
            fmt::format("out of reach: {:.6g} away from the base, but the tip of link {} cannot come nearer "
                        "than {:.6g}",
                        most, goal.number, nearest));
}
}  // namespace narrows
