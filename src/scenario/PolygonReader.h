// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kernel/PlanarObstacle.h"
#include "scenario/YamlField.h"

namespace narrows
{
/// A list of 3 to `most` vertices. Nothing (and a fault) unless they bound a simple polygon with an area.
/// \return counter-clockwise
std::optional<Polygon> readPolygon(const Field &field, std::size_t most);

/// The same that must be convex besides; vertices on straight sides do no harm.
std::optional<Polygon> readConvexPolygon(const Field &field, std::size_t most);

/// The polygon of vertices that are known; faults as above.
std::optional<Polygon> makePolygon(const Field &field, const std::vector<Eigen::Vector2d> &vertices);
}  // namespace narrows
