// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/SpatialOverlap.h"

namespace narrows
{
SpatialOverlap::SpatialOverlap(const SpatialModel &model) : poles_(model)
{
    for (const SpatialObstacle &obstacle : model.obstacles)
        boxes_.push_back(spatialBounds(obstacle));
}

double SpatialOverlap::deepest(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient)
{
    poles_.arm().place(q, placement_);
    double depth = 0.0;
    for (std::size_t link = 0; link < poles_.arm().links().size(); ++link)
        lookAtObstacles(link, depth);
    lookAtPairs(depth);
    if (depth < 0.0)
        gatherGradient(poles_.arm(), placement_, forces_, gradient);
    return depth;
}

void SpatialOverlap::lookAtObstacles(std::size_t link, double &depth)
{
    const double radius = poles_.arm().links()[link].radius;
    const Eigen::Vector3d &a = placement_.points[2 * link], &b = placement_.points[2 * link + 1];
    const SpatialBounds around = boundsAround(a, b, radius);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
    {
        if (!boxes_[i].meets(around))
            continue;
        const SpatialTerm term = poles_.obstacles()[i].clearance(a, b, radius);
        if (!(term.value < depth))
            continue;
        depth = term.value;
        forces_.assign(poles_.arm().links().size(), {});
        forces_[link] = term.slope;
    }
}

void SpatialOverlap::lookAtPairs(double &depth)
{
    for (const auto &[first, second] : poles_.pairs())
    {
        const SpatialPairTerm term = pairClearance(poles_.arm(), placement_, first, second);
        if (!(term.value < depth))
            continue;
        depth = term.value;
        forces_.assign(poles_.arm().links().size(), {});
        forces_[static_cast<std::size_t>(first)] = term.first;
        forces_[static_cast<std::size_t>(second)] = term.second;
    }
}
}  // namespace narrows
