// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "kernel/SpatialBounds.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
/// A convex obstacle in space by what gaps are made of: its distance from segments, its edges, and what of it faces a
/// direction.
class SpatialShape
{
public:
    using Convex = std::variant<Sphere, Capsule, Cylinder, Box, Prism>;  ///< shapes that are convex
    using Edge = std::pair<Eigen::Vector3d, Eigen::Vector3d>;            ///< its two ends

    /// \param far > 0: endless shapes end so far from their center
    SpatialShape(const Convex &convex, double far);

    /// How the segment ab lies to it.
    Nearness nearest(const Eigen::Vector3d &a, const Eigen::Vector3d &b) const;
    /// The border is part of it.
    bool contains(const Eigen::Vector3d &point) const { return nearest(point, point).distance <= 0.0; }
    const SpatialBounds &box() const { return box_; }  ///< axis-parallel box around it

    /// Segments, points among them; all within edgeRadius() of them belongs to the shape. Of spheres and capsules that
    /// is all; of boxes and prisms they are the edges, of cylinders the axis.
    const std::vector<Edge> &edges() const { return edges_; }
    double edgeRadius() const { return edgeRadius_; }  ///< of the ball around edges; 0 for sharp ones
    /// Whether it is round, but no ball around its edges: a cylinder.
    bool isCylinder() const { return std::holds_alternative<Cylinder>(convex_); }

    /// Points that span what lies furthest in a direction (unit) or less than `depth` behind: a corner, the ends of an
    /// edge or of a round one's line, the corners of a face or, about a round one, of a square.
    std::vector<Eigen::Vector3d> facing(const Eigen::Vector3d &direction, double depth) const;
    /// Half its least breadth.
    double leastHalfBreadth() const { return leastHalfBreadth_; }

private:
    void take(const Sphere &sphere);
    void take(const Capsule &capsule);
    void take(const Cylinder &cylinder);
    void take(const Box &box);
    void take(const Prism &prism);

    Convex convex_;
    std::vector<Edge> edges_;
    double edgeRadius_ = 0.0, leastHalfBreadth_ = 0.0;
    SpatialBounds box_;
};

/// Where two convex shapes are nearest to each other.
struct SpatialNearestPoints
{
    Eigen::Vector3d first;      ///< point of the first shape
    Eigen::Vector3d second;     ///< of the second
    Eigen::Vector3d direction;  ///< unit vector from the first shape to the second
    double distance;            ///< not positive: the shapes meet, and the rest means nothing
};

/// Exact without cylinders: two edges are nearest to each other, or an edge to a face. With one, points are projected
/// from one shape to the other until they move by less than 1e-13, 2000 times at most.
SpatialNearestPoints nearestPoints(const SpatialShape &first, const SpatialShape &second);
}  // namespace narrows
