// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kernel/PrismView.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

Nearness nearness(const Vector3d &a, const Vector3d &b, const Prism &prism)
{
    const auto axes = prism.pose.linear();
    const PrismView view(axes.transpose() * (a - prism.pose.translation()), axes.transpose() * (b - a), prism);
    const double t = view.closest();
    const Vector3d excess = view.excess(t);
    const double distance = excess.norm();
    double size = 0.0;
    for (const Vector2d &vertex : prism.vertices)
        size = std::max(size, (vertex - prism.vertices[0]).lpNorm<Eigen::Infinity>());
    const Nearness outside{distance, t, a + t * (b - a), axes * (excess / distance)};
    if (distance > 1e-9 * size)
        return outside;
    // Where the segment passes through, rounding may have stopped the search just outside.
    const double deepest = view.deepest();
    const PrismView::Height height = view.highestAt(deepest);
    if (distance > 0.0 && distance <= height.at(deepest))
        return outside;
    return {height.at(deepest), deepest, a + deepest * (b - a), axes * height.normal};
}
}  // namespace narrows
