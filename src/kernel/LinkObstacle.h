// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/LinkTerm.h"
#include "kernel/PlanarObstacle.h"

namespace narrows
{
/// An obstacle as one link sees it. Immutable.
class LinkObstacle
{
public:
    virtual ~LinkObstacle() = default;

    /// The obstacle function C of PlanarRepulsionModel.h: 0 where link and obstacle touch, positive outside.
    virtual LinkTerm pole(const Segment &link) const = 0;
    /// Distance of the link's edge from the obstacle, negative where they meet (see PlanarRepulsionModel.h).
    virtual LinkTerm clearance(const Segment &link) const = 0;
    /// Whether the link overlaps the obstacle: pole(link).value < 0, which may cost far more.
    virtual bool isMet(const Segment &link) const { return pole(link).value < 0.0; }
};

/// \param linkRadius half-width of the links
/// \param reach upper bound of R, the size that the obstacle's function counts with
std::unique_ptr<const LinkObstacle> makeLinkObstacle(const PlanarObstacle &obstacle, double linkRadius, double reach);
}  // namespace narrows
