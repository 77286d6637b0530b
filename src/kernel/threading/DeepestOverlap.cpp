// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/DeepestOverlap.h"

namespace narrows
{
DeepestOverlap::DeepestOverlap(const PlanarModel &model) : poles_(model, {})
{
    for (const PlanarObstacle &obstacle : model.obstacles)
    {
        boxes_.push_back(bounds(obstacle));
        boxes_.back().lower.array() -= model.arm.radius();
        boxes_.back().upper.array() += model.arm.radius();
    }
}

double DeepestOverlap::deepest(ConfigurationRef q, Eigen::VectorXd &gradient)
{
    poles_.arm().place(q, points_);
    poles_.segments(points_, links_);
    double depth = 0.0;
    std::size_t deepestLink = 0;
    LinkForce force;
    for (std::size_t t = 0; t < links_.size(); ++t)
    {
        const Eigen::Vector2d tip = links_[t].tip();
        const Eigen::Vector2d lower = links_[t].base.cwiseMin(tip), upper = links_[t].base.cwiseMax(tip);
        for (std::size_t i = 0; i < boxes_.size(); ++i)
        {
            if ((lower.array() > boxes_[i].upper.array()).any() || (upper.array() < boxes_[i].lower.array()).any())
                continue;
            const LinkTerm term = poles_.obstacles()[i]->pole(links_[t]);
            if (!(term.value < depth))
                continue;
            depth = term.value;
            deepestLink = t;
            force = term.slope;
        }
    }
    if (depth < 0.0)
    {
        forces_.assign(links_.size(), {});
        forces_[deepestLink] = force;
        gatherGradient(poles_.arm(), points_, forces_, carried_, gradient);
    }
    return depth;
}
}  // namespace narrows
