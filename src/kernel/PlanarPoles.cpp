// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarPoles.h"

#include <algorithm>
#include <stdexcept>

namespace narrows
{
PlanarPoles::PlanarPoles(const PlanarModel &model, const JointLimits &limits) : arm_(model.arm)
{
    double longest = 0.0;
    for (const PlanarLink &link : arm_.links())
    {
        inverseSquares_.push_back(1.0 / (link.length * link.length));
        longest = std::max(longest, link.length);
    }
    const double reach = 0.5 * longest;
    pairSize_ = 2.0 * (reach + 2.0 * arm_.radius());
    for (const PlanarObstacle &obstacle : model.obstacles)
    {
        obstacles_.push_back(makeLinkObstacle(obstacle, arm_.radius(), reach));
        groups_.push_back(obstacle.name);
    }
    addLimits(limits);
    if (!limits_.empty())
    {
        limitGroup_ = static_cast<int>(groups_.size());
        groups_.push_back("limits");
    }
    if (model.selfCollision)
        for (int i = 0; i < arm_.linkCount(); ++i)
            for (int j = i + 1; j < arm_.linkCount(); ++j)
                if (!arm_.areNeighbours(i, j))
                    pairs_.push_back({i, j});
    if (!pairs_.empty())
    {
        selfGroup_ = static_cast<int>(groups_.size());
        groups_.push_back("self");
    }
}

void PlanarPoles::addLimits(const JointLimits &limits)
{
    if (limits.angles.size() > arm_.links().size())
        throw std::invalid_argument("there are more joint limits than links");
    if (arm_.slide())
    {
        limits_.push_back({1.0, 0, -1, arm_.slide()->lower});
        limits_.push_back({-1.0, 0, -1, arm_.slide()->upper});
    }
    const int first = arm_.firstAngle();
    for (int i = 0; i < static_cast<int>(limits.angles.size()); ++i)
        if (limits.angles[i])
        {
            const int parent = arm_.links()[i].parent;
            const bool relative = limits.convention == AngleConvention::Relative && parent >= 0;
            const int against = relative ? first + parent : -1;
            limits_.push_back({1.0, first + i, against, limits.angles[i]->lower});
            limits_.push_back({-1.0, first + i, against, limits.angles[i]->upper});
        }
}

void PlanarPoles::segments(const std::vector<Eigen::Vector2d> &points, std::vector<Segment> &links) const
{
    links.resize(inverseSquares_.size());
    for (std::size_t t = 0; t < links.size(); ++t)
    {
        const Eigen::Vector2d &base = points[arm_.links()[t].parent + 1];
        links[t] = {base, points[t + 1] - base, inverseSquares_[t]};
    }
}
}  // namespace narrows
