// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/TipPathGoal.h"

#include <stdexcept>

namespace narrows
{
namespace
{
SpatialTipGoal lastOf(const SpatialTipPath &path)
{
    if (path.points.empty())
        throw std::invalid_argument("a tip path needs at least one point");
    return tipGoalAt(path, path.points.size() - 1);
}
}  // namespace

SpatialTipGoal tipGoalAt(const SpatialTipPath &path, std::size_t index)
{
    return {path.link, path.points[index], path.tolerance};
}

std::optional<SpatialTipPath> tipPathOf(const ob::Goal &goal)
{
    if (const auto *path = dynamic_cast<const TipPathGoal *>(&goal))
        return path->path();
    if (const auto *region = dynamic_cast<const SpatialTipGoalRegion *>(&goal))
        return SpatialTipPath{region->goal().link, {region->goal().point}, region->goal().tolerance};
    return std::nullopt;
}

TipPathGoal::TipPathGoal(const ob::SpaceInformationPtr &si, const SpatialTipPath &path)
  : SpatialTipGoalRegion(si, lastOf(path)), path_(path)
{
}
}  // namespace narrows
